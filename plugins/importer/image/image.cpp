/// Pictures from files, read by OpenImageIO in a process of its own.
#include <lumen/image.h>
#include <lumen/importer.h>

namespace {

struct ImageImporter : lumen::Importer {
  using Importer::Importer;
  lumen::Property<lumen::Path> path{this, "path", {}, {.doc = "the file to read"}};
  lumen::Output<lumen::Image> image{this, "image", {.doc = "the picture: 8- and 16-bit colors decoded from sRGB to linear, floats as they are"}};

  std::vector<lumen::FileFormat> formats() const override {
    using lumen::DataKind;
    return {{".png", DataKind::image, "PNG"},  {".exr", DataKind::image, "OpenEXR"}, {".pfm", DataKind::image, "Portable float map"},
            {".ppm", DataKind::image, "PPM"},  {".pgm", DataKind::image, "PGM"},     {".pbm", DataKind::image, "PBM"},
            {".jpg", DataKind::image, "JPEG"}, {".jpeg", DataKind::image, "JPEG"},   {".tif", DataKind::image, "TIFF"},
            {".tiff", DataKind::image, "TIFF"}, {".tga", DataKind::image, "Targa"},  {".bmp", DataKind::image, "BMP"},
            {".hdr", DataKind::image, "Radiance"}, {".webp", DataKind::image, "WebP"}};
  }

  void compute(lumen::Job& job) const override {
    const std::string& file = job[path].file;
    if (file.empty()) return;
    const lumen::WorkerReply reply = job.run({"openimageio", "read", {{"path", file}}, {}, file});
    for (const lumen::DataPointer& data : reply.data)
      if (auto picture = std::dynamic_pointer_cast<const lumen::Image>(data)) job.set(image, picture);
  }
};
LUMEN_PLUGIN(ImageImporter, "importer.image", "pictures from any format that OpenImageIO reads")

}  // namespace
