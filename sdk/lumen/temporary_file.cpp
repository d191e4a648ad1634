/// A rename replaces a file at once: whoever opens the target finds the old or the new one, whole.
#include <lumen/temporary_file.h>

#include <filesystem>
#include <random>

#include <lumen/error.h>

namespace lumen {

namespace files = std::filesystem;

TemporaryFile::TemporaryFile(std::string target) : target_(std::move(target)) {
  const files::path path(target_);
  const files::path folder = path.has_parent_path() ? path.parent_path() : files::path(".");
  std::error_code error;
  if (!path.has_filename()) throw Error(target_, "is no file name");
  if (!files::is_directory(folder, error)) throw Error(target_, "there is no folder " + folder.string());
  if (const auto status = files::status(path, error); files::exists(status) && !files::is_regular_file(status))
    throw Error(target_, "is there and is no regular file");
  const std::string mark = std::to_string(std::random_device{}());
  path_ = (folder / ("." + path.stem().string() + "." + mark + path.extension().string())).string();
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  files::remove(path_, ignored);
}

void TemporaryFile::commit() {
  std::error_code error;
  files::rename(path_, target_, error);
  if (error) throw Error(target_, "cannot be written: " + error.message());
}

}  // namespace lumen
