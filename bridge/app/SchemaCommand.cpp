#include "bridge/app/SchemaCommand.h"

#include <iostream>
#include <memory>

#include "bridge/scene/SchemaPrinter.h"
#include "bridge/scene/Units.h"

namespace restenosis {

void addSchemaCommand(CLI::App& app, int&) {
  auto* command = app.add_subcommand("schema", "print every key with unit, default, bounds, source");
  auto markdown = std::make_shared<bool>(false);
  command->add_flag("--markdown", *markdown, "as Markdown tables");
  command->callback([markdown] {
    const Units units;
    std::cout << (*markdown ? schemaMarkdown(units) : schemaText(units));
  });
}

}  // namespace restenosis
