/// `lumenshop render`: a session or data becomes a picture file, or one per frame.
#include <cstdio>
#include <future>

#include <malloc.h>

#include <lumen/error.h>

#include "command/commands.h"
#include "command/frame_name.h"
#include "command/offscreen.h"
#include "command/picture_encoding.h"
#include "format_catalog.h"

namespace lumenshop {
namespace {

constexpr double frames_per_second = 25;
constexpr const char* all_layers[] = {"color",    "depth",     "normal",  "position",    "albedo", "ambient", "diffuse",
                                      "specular", "occlusion", "opacity", "transparent", "id"};

std::vector<std::string> layers_of(const RenderOptions& options) {
  if (options.layer != "all") return {options.layer};
  if (options.output.extension() != ".exr")
    throw lumen::Error(options.output.string(), "only EXR holds all layers in one picture", "name an .exr file, or one layer");
  return {std::begin(all_layers), std::end(all_layers)};
}

/// The worker modules that read the files and write the picture: VTK alone takes as long to load as all plugins.
std::vector<std::string> workers_of(const RenderOptions& options) {
  std::vector<std::string> workers;
  if (options.files.front().extension() != ".json") workers.push_back("vtk");
  workers.push_back(options.output.extension() == ".png" ? "png" : "openimageio");
  return workers;
}

std::shared_ptr<lumen::Image> picture_of(Offscreen& offscreen, const RenderOptions& options, const std::vector<std::string>& layers) {
  ViewRenderer& view = offscreen.view();
  if (options.layer == "all") {
    std::vector<std::pair<std::string, std::shared_ptr<lumen::Image>>> images;
    for (const std::string& layer : layers) images.emplace_back(layer, view.layer(layer));
    return combined(images);
  }
  return view.layer(options.layer);
}

/// What goes to the file.
std::shared_ptr<lumen::Image> encoded(std::shared_ptr<lumen::Image> image, const RenderOptions& options, const DisplayOptions& display) {
  return options.layer == "all" || keeps_floats(options.output) ? image : displayable(*image, options.layer, display);
}

DisplayOptions display_of(Offscreen& offscreen, const std::string& view_id) {
  const auto [instance, slot] = offscreen.workshop().session().resolve(view_id + ".encode_srgb");
  return {.encode_srgb = std::get<bool>(instance->read(slot)), .extent = scene_extent(offscreen.view().camera(), offscreen.view().scene_bounds())};
}

/// Returning memory costs less than finding it again, but layers, which are large, go at once: the peak counts.
void keep_memory() {
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  mallopt(M_TRIM_THRESHOLD, 16 << 20);
  mallopt(M_TOP_PAD, 1 << 20);
}

}  // namespace

int run_render(const RenderOptions& options, const std::vector<std::filesystem::path>& plugin_folders) {
  keep_memory();
  const std::vector<std::string> layers = layers_of(options);
  Offscreen offscreen({.files = options.files, .plugin_folders = plugin_folders, .overrides = options.overrides,
                       .view = options.view, .size = options.size, .warm_workers = workers_of(options), .layers = layers});
  Workshop& workshop = offscreen.workshop();
  const FormatCatalog formats(workshop.registry());
  Instance& exporter = formats.exporter_of(options.output, lumen::DataKind::image);

  const std::string view_id = options.view.empty() ? workshop.session().views().front()->id() : options.view;
  Findings findings;
  std::future<void> written;  // beside what comes after
  const auto write = [&](std::shared_ptr<lumen::Image> picture, const DisplayOptions& display, const std::filesystem::path& file) {
    picture = encoded(std::move(picture), options, display);
    if (written.valid()) written.get();
    written = workshop.scheduler().start_writing(exporter, std::move(picture), std::filesystem::absolute(file));
  };
  if (!options.frames) {
    offscreen.finish();
    malloc_trim(0);
    auto image = picture_of(offscreen, options, layers);
    const DisplayOptions display = display_of(offscreen, view_id);
    findings = offscreen.all_findings();
    offscreen.drop_scene();  // its memory serves what follows
    write(std::move(image), display, options.output);
    offscreen.drop_context();  // takes about as long as the file
  } else {
    for (int frame = options.frames->first; frame <= options.frames->last; ++frame) {
      workshop.session().override_value(view_id + ".time", std::to_string(frame / frames_per_second));
      offscreen.finish();
      write(picture_of(offscreen, options, layers), display_of(offscreen, view_id), frame_name(options.output, frame));
    }
    findings = offscreen.all_findings();
  }
  if (written.valid()) written.get();
  std::fputs(findings.text().c_str(), stderr);
  return findings.empty() ? exit_well : exit_failed;
}

}  // namespace lumenshop
