/// `lumenshop export`: an instance's data becomes a file.
#include <cstdio>

#include <lumen/error.h>

#include "command/commands.h"
#include "command/findings.h"
#include "format_catalog.h"
#include "workshop.h"

namespace lumenshop {

int run_export(const ExportOptions& options, const std::vector<std::filesystem::path>& plugin_folders) {
  Workshop workshop({.plugin_folders = plugin_folders});
  workshop.open({options.session});
  Session& session = workshop.session();
  for (const Override& override : options.overrides) session.override_value(override.path, override.value);

  const auto [instance, slot] = session.resolve(options.property);
  const lumen::PropertySpec spec = instance->spec(slot);
  if (spec.type != lumen::ValueType::data)
    throw lumen::Error(options.property, "is no data but a " + std::string(lumen::name_of(spec.type)), "export takes outputs, as scan.mesh");
  const FormatCatalog formats(workshop.registry());
  Instance& exporter = formats.exporter_of(options.output, spec.data_kind);

  session.update();
  workshop.scheduler().wait();
  const lumen::DataPointer data = std::get<lumen::DataPointer>(instance->read(slot));
  if (!data) {
    Findings findings;
    findings.add(workshop.problems());
    if (findings.empty()) findings.add(options.property + ": has no data (" + instance->slots()[slot]->data_state + ")");
    std::fputs(findings.text().c_str(), stderr);
    return exit_failed;
  }
  workshop.scheduler().write_file(exporter, data, std::filesystem::absolute(options.output));
  return exit_well;
}

}  // namespace lumenshop
