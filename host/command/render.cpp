/// `lumenshop render`: a session or data becomes a picture file, or one per frame.
#include <cstdio>

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
                       .view = options.view, .size = options.size, .warm_worker = options.output.extension() == ".png" ? "png" : "openimageio"});
  Workshop& workshop = offscreen.workshop();
  const FormatCatalog formats(workshop.registry());
  Instance& exporter = formats.exporter_of(options.output, lumen::DataKind::image);
  offscreen.view().request(layers);

  const std::string view_id = options.view.empty() ? workshop.session().views().front()->id() : options.view;
  Findings findings;
  if (!options.frames) {
    offscreen.finish();
    malloc_trim(0);
    auto image = picture_of(offscreen, options, layers);
    const DisplayOptions display = display_of(offscreen, view_id);
    findings = offscreen.all_findings();
    offscreen.release();
    image = encoded(std::move(image), options, display);
    workshop.scheduler().write_file(exporter, std::move(image), std::filesystem::absolute(options.output));
  } else {
    for (int frame = options.frames->first; frame <= options.frames->last; ++frame) {
      workshop.session().override_value(view_id + ".time", std::to_string(frame / frames_per_second));
      offscreen.finish();
      workshop.scheduler().write_file(exporter, encoded(picture_of(offscreen, options, layers), options, display_of(offscreen, view_id)),
                                      std::filesystem::absolute(frame_name(options.output, frame)));
    }
    findings = offscreen.all_findings();
  }
  std::fputs(findings.text().c_str(), stderr);
  return findings.empty() ? exit_well : exit_failed;
}

}  // namespace lumenshop
