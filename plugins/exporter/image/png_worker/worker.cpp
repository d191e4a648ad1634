/// The worker module `png`: the most common picture without OpenImageIO, whose 261 libraries take longer to load than a
/// picture takes to write. Verb write, arguments as those of the module `openimageio`.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

#include <png.h>

#include <lumen/image.h>
#include <lumen/worker.h>

namespace {

struct Bytes {
  std::vector<std::uint8_t> values;
  std::size_t width, height, channels;
};

/// The first 1 to 4 channels, clamped and rounded.
Bytes bytes_of(const lumen::Image& image) {
  const std::size_t present = image.channels.size();
  Bytes bytes{{}, static_cast<std::size_t>(image.width), static_cast<std::size_t>(image.height), std::min<std::size_t>(present, 4)};
  bytes.values.resize(bytes.width * bytes.height * bytes.channels);
  std::uint8_t* target = bytes.values.data();
  for (std::size_t pixel = 0; pixel < bytes.width * bytes.height; ++pixel)
    for (std::size_t channel = 0; channel < bytes.channels; ++channel) {
      const float number = image.pixels[pixel * present + channel];
      // NaN fails the comparison and becomes black.
      *target++ = static_cast<std::uint8_t>(number > 0 ? std::min(number, 1.0f) * 255.0f + 0.5f : 0.0f);
    }
  return bytes;
}

struct Failure {
  char text[200] = "";
};

void on_error(png_structp png, png_const_charp text) {
  auto* failure = static_cast<Failure*>(png_get_error_ptr(png));
  std::snprintf(failure->text, sizeof failure->text, "%s", text);
  png_longjmp(png, 1);
}

/// False with a text if libpng jumped out. Holds nothing that has a destructor: a jump passes it by.
bool encode(std::FILE* file, const Bytes& bytes, Failure& failure) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure, on_error, [](png_structp, png_const_charp) {});
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info || setjmp(png_jmpbuf(png))) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  const int color_types[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGBA};
  png_init_io(png, file);
  png_set_IHDR(png, info, static_cast<png_uint_32>(bytes.width), static_cast<png_uint_32>(bytes.height), 8, color_types[bytes.channels - 1],
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, 3);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  char key[] = "Software", value[] = "lumenshop";
  png_text text{};
  text.compression = PNG_TEXT_COMPRESSION_NONE;
  text.key = key;
  text.text = value;
  png_set_text(png, info, &text, 1);
  png_write_info(png, info);
  for (std::size_t row = 0; row < bytes.height; ++row) png_write_row(png, bytes.values.data() + row * bytes.width * bytes.channels);
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return true;
}

void run(const lumen::WorkerRequest& request, lumen::WorkerReply&, lumen::WorkerProgress progress) {
  if (request.verb != "write") throw lumen::Error("png", "no verb '" + request.verb + "'");
  const std::string& path = request.arguments.at("path");
  const std::string name = request.arguments.contains("name") ? request.arguments.at("name") : path;
  const auto* image = request.inputs.empty() ? nullptr : dynamic_cast<const lumen::Image*>(request.inputs.front().get());
  if (!image) throw lumen::Error(name, "there is no picture to write");
  const Bytes bytes = bytes_of(*image);
  progress(0.3f);
  const auto close = [](std::FILE* file) { std::fclose(file); };
  std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "wb"), close);
  Failure failure;
  if (!file || !encode(file.get(), bytes, failure) || std::fflush(file.get()) != 0)
    throw lumen::Error(name, std::string("cannot be written") + (*failure.text ? std::string(": ") + failure.text : ""), "check the folder and the space on the disk");
}

}  // namespace

LUMEN_WORKER(run)
