/// Pictures into files, written by OpenImageIO in a process of its own.
#include <algorithm>
#include <cctype>
#include <filesystem>

#include <lumen/exporter.h>
#include <lumen/image.h>
#include <lumen/temporary_file.h>

namespace {

struct ImageExporter : lumen::Exporter {
  using Exporter::Exporter;
  lumen::Input<lumen::Image> image{this, "image", {.doc = "the picture to write; 8-bit formats take its numbers as they are, 0 to 1"}};
  lumen::Property<lumen::Choice> depth{this, "depth", {"auto"}, {.doc = "numbers in the file: 8 bit, 32-bit float, or what suits the format", .choices = {"auto", "8", "float"}}};

  std::vector<lumen::FileFormat> formats() const override {
    using lumen::DataKind;
    return {{".png", DataKind::image, "PNG"},  {".exr", DataKind::image, "OpenEXR"}, {".pfm", DataKind::image, "Portable float map"},
            {".ppm", DataKind::image, "PPM"},  {".jpg", DataKind::image, "JPEG"},    {".jpeg", DataKind::image, "JPEG"},
            {".tif", DataKind::image, "TIFF"}, {".tiff", DataKind::image, "TIFF"},   {".tga", DataKind::image, "Targa"},
            {".bmp", DataKind::image, "BMP"},  {".hdr", DataKind::image, "Radiance"}, {".webp", DataKind::image, "WebP"}};
  }

  void write(lumen::Job& job) const override {
    const std::string& file = job[path].file;
    if (file.empty()) throw lumen::Error("exporter.image", "no file to write to", "set path");
    const auto picture = job[image];
    if (!picture) throw lumen::Error(file, "there is no picture to write");
    lumen::TemporaryFile temporary(file);
    // OpenImageIO takes longer to load than a picture takes to write.
    std::string extension = std::filesystem::path(file).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
    const char* module = extension == ".png" && !(job[depth] == "float") ? "png" : "openimageio";
    job.run({module, "write", {{"path", temporary.path()}, {"depth", job[depth].name}, {"name", file}}, {picture}});
    temporary.commit();
  }
};
LUMEN_PLUGIN(ImageExporter, "exporter.image", "writes pictures in any format that OpenImageIO writes: png exr pfm ppm jpg tif ...")

}  // namespace
