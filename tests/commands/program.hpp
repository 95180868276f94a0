// sphlab as a user meets it: a process with arguments and an environment, two streams and an exit code.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sph {

/// What differs from the test's own surroundings.
struct Surroundings {
  std::map<std::string, std::optional<std::string>> environment = {};  ///< no value: the variable is not set
  std::string stdout_file = {};                                        ///< where stdout goes instead
};

struct Outcome {
  int exit_code = 0;  ///< or minus the signal that ended the program
  std::string out;    ///< what it wrote on stdout
  std::string err;    ///< and on stderr
};

/// One run of the program, in the background; killed if nobody waited for its end.
class Program {
 public:
  using Arguments = std::vector<std::string>;

  explicit Program(const Arguments& arguments, const Surroundings& surroundings = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Waits until stderr has had `part`; false if the program ended, or a minute passed, without it.
  bool Says(const std::string& part);
  void Signal(int number) const;
  Outcome Wait();

 private:
  bool ReadSome();  // false at the end of both streams, or when nothing came for a minute

  pid_t pid_ = -1;
  int out_ = -1, err_ = -1;  // the reading ends; -1 when at their end
  Outcome outcome_;
};

/// Runs it to its end.
Outcome RunProgram(const Program::Arguments& arguments, const Surroundings& surroundings = {});

/// Does the program end with this exit code, nothing on stdout, and a message on stderr that has each of `parts`?
testing::AssertionResult Refuses(int exit_code, const Program::Arguments& arguments,
                                 const std::vector<std::string>& parts, const Surroundings& surroundings = {});

}  // namespace sph
