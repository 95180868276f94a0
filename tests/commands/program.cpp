#include "commands/program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

extern char** environ;

namespace sph {
namespace {

constexpr int kPatience = 60'000;  // [ms]; a hundred times what anything here takes

std::vector<std::string> Environment(const Surroundings& surroundings) {
  std::vector<std::string> entries;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (!surroundings.environment.contains(text.substr(0, text.find('=')))) entries.push_back(text);
  }
  for (const auto& [name, value] : surroundings.environment) {
    if (value) entries.push_back(name + "=" + *value);
  }
  return entries;
}

std::vector<char*> Pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Takes what a stream has; closes it at its end.
void Drain(int& stream, std::string& text) {
  std::array<char, 4096> bytes;
  const ssize_t count = read(stream, bytes.data(), bytes.size());
  if (count > 0) {
    text.append(bytes.data(), static_cast<std::size_t>(count));
  } else {
    close(stream);
    stream = -1;
  }
}

}  // namespace

Program::Program(const Arguments& arguments, const Surroundings& surroundings) {
  std::vector<std::string> command = {SPHLAB_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = Environment(surroundings);
  std::array<int, 2> out = {-1, -1}, err = {-1, -1};
  if (pipe2(out.data(), O_CLOEXEC) != 0 || pipe2(err.data(), O_CLOEXEC) != 0) ADD_FAILURE() << std::strerror(errno);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  if (surroundings.stdout_file.empty()) {
    posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  } else {
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, surroundings.stdout_file.c_str(), O_WRONLY, 0);
  }
  posix_spawn_file_actions_adddup2(&actions, err[1], STDERR_FILENO);
  const int error =
      posix_spawn(&pid_, SPHLAB_PROGRAM, &actions, nullptr, Pointers(command).data(), Pointers(environment).data());
  if (error != 0) {
    ADD_FAILURE() << SPHLAB_PROGRAM << ": " << std::strerror(error);
    pid_ = -1;
  }
  posix_spawn_file_actions_destroy(&actions);
  close(out[1]);
  close(err[1]);
  out_ = out[0];
  err_ = err[0];
}

Program::~Program() {
  for (const int stream : {out_, err_}) {
    if (stream >= 0) close(stream);
  }
  if (pid_ < 0) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

bool Program::ReadSome() {
  std::array<pollfd, 2> streams = {pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0}};  // poll leaves -1 out
  if ((out_ < 0 && err_ < 0) || poll(streams.data(), streams.size(), kPatience) <= 0) return false;
  if (streams[0].revents != 0) Drain(out_, outcome_.out);
  if (streams[1].revents != 0) Drain(err_, outcome_.err);
  return true;
}

bool Program::Says(const std::string& part) {
  while (outcome_.err.find(part) == std::string::npos) {
    if (!ReadSome()) return false;
  }
  return true;
}

void Program::Signal(int number) const { kill(pid_, number); }

Outcome Program::Wait() {
  while (out_ >= 0 || err_ >= 0) ReadSome();  // as long as it takes: ctest ends what hangs
  int status = 0;
  if (pid_ >= 0 && waitpid(pid_, &status, 0) != pid_) ADD_FAILURE() << std::strerror(errno);
  pid_ = -1;
  outcome_.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return outcome_;
}

Outcome RunProgram(const Program::Arguments& arguments, const Surroundings& surroundings) {
  return Program(arguments, surroundings).Wait();
}

testing::AssertionResult Refuses(int exit_code, const Program::Arguments& arguments,
                                 const std::vector<std::string>& parts, const Surroundings& surroundings) {
  const Outcome outcome = RunProgram(arguments, surroundings);
  if (outcome.exit_code != exit_code) {
    return testing::AssertionFailure() << "exit code " << outcome.exit_code << ", said: " << outcome.err;
  }
  if (!outcome.out.empty()) return testing::AssertionFailure() << "on stdout: " << outcome.out;
  if (!outcome.err.starts_with("sphlab: ")) return testing::AssertionFailure() << "said: " << outcome.err;
  for (const std::string& part : parts) {
    if (outcome.err.find(part) == std::string::npos) {
      return testing::AssertionFailure() << "no '" << part << "' in: " << outcome.err;
    }
  }
  return testing::AssertionSuccess() << outcome.err;
}

}  // namespace sph
