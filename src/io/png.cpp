#include "io/png.hpp"

#include <png.h>
#include <zlib.h>

#include <csetjmp>

#include "base/check.hpp"
#include "base/error.hpp"
#include "io/whole_file.hpp"

namespace sph {
namespace {

/// What a picture is stored as: black disks and grey text need one byte a pixel, not three.
struct Rows {
  std::vector<std::uint8_t> grey;  // empty for a coloured picture
  const std::uint8_t* first = nullptr;
  std::size_t stride = 0;  // [bytes]
};

bool IsGrey(const Image& image) {
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    if (image.rgb[i] != image.rgb[i + 1] || image.rgb[i] != image.rgb[i + 2]) return false;
  }
  return true;
}

Rows RowsOf(const Image& image) {
  const auto width = static_cast<std::size_t>(image.width);
  if (!IsGrey(image)) return {{}, image.rgb.data(), 3 * width};
  Rows rows{std::vector<std::uint8_t>(image.rgb.size() / 3), nullptr, width};
  for (std::size_t i = 0; i < rows.grey.size(); ++i) rows.grey[i] = image.rgb[3 * i];
  rows.first = rows.grey.data();
  return rows;
}

void Append(png_structp png, png_bytep bytes, std::size_t count) {
  auto& file = *static_cast<std::vector<std::byte>*>(png_get_io_ptr(png));
  const auto* first = reinterpret_cast<const std::byte*>(bytes);
  file.insert(file.end(), first, first + count);
}

/// The fastest settings that still make small files, measured on frames of 1280 x 720 pixels: run lengths alone, at
/// level 1; no filter for grey (2 to 12 ms, level 6: 3 to 100), differences to the left for colours (6 to 15 ms).
void ChooseFastSettings(png_structp png, bool grey) {
  png_set_compression_level(png, 1);
  png_set_compression_strategy(png, Z_RLE);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, grey ? PNG_FILTER_NONE : PNG_FILTER_SUB);
  png_set_compression_buffer_size(png, std::size_t{1} << 16);
}

/// False if libpng gives up: it then jumps back here, so nothing in this function may need a destructor.
bool Encode(png_structp png, png_infop info, const Image& image, const Rows& rows, std::vector<std::byte>& file) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &file, Append, nullptr);
  const bool grey = !rows.grey.empty();
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
               grey ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  ChooseFastSettings(png, grey);
  png_write_info(png, info);
  for (int y = 0; y < image.height; ++y) png_write_row(png, rows.first + static_cast<std::size_t>(y) * rows.stride);
  png_write_end(png, info);
  return true;
}

}  // namespace

std::vector<std::byte> EncodePng(const Image& image) {
  SPH_CHECK(image.width > 0 && image.height > 0, "size {} x {}", image.width, image.height);
  const auto bytes = std::size_t{3} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  SPH_CHECK(image.rgb.size() == bytes, "{} bytes for {} x {} pixels", image.rgb.size(), image.width, image.height);

  const Rows rows = RowsOf(image);
  std::vector<std::byte> file;
  file.reserve(bytes / 8);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  SPH_CHECK(png != nullptr, "libpng other than {}, or no memory", PNG_LIBPNG_VER_STRING);
  png_infop info = png_create_info_struct(png);
  const bool encoded = Encode(png, info, image, rows, file);
  png_destroy_write_struct(&png, &info);
  if (!encoded) throw TroubleError("a picture of {} x {} pixels: libpng cannot encode it", image.width, image.height);
  return file;
}

void WritePng(const std::filesystem::path& path, const Image& image) { WriteWholeFile(path, EncodePng(image)); }

Image ReadPng(const std::filesystem::path& path) {
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  Image image;
  if (png_image_begin_read_from_file(&png, path.c_str()) != 0) {
    png.format = PNG_FORMAT_RGB;
    image.width = static_cast<int>(png.width);
    image.height = static_cast<int>(png.height);
    image.rgb.resize(PNG_IMAGE_SIZE(png));
    const png_color white = {255, 255, 255};
    png_image_finish_read(&png, &white, image.rgb.data(), 0, nullptr);
  }
  if (PNG_IMAGE_FAILED(png)) {
    png_image_free(&png);
    throw TroubleError("cannot read {} as a PNG picture: {}", path.string(), png.message);
  }
  return image;
}

}  // namespace sph
