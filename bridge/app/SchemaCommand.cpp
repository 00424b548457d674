#include "bridge/app/SchemaCommand.h"

#include <iostream>
#include <memory>

#include "bridge/scene/JsonSchema.h"
#include "bridge/scene/SchemaPrinter.h"
#include "bridge/scene/Units.h"

namespace restenosis {

void addSchemaCommand(CLI::App& app, int&) {
  auto* command = app.add_subcommand("schema", "print every key with unit, default, bounds, source");
  struct Arguments {
    bool markdown = false, json = false;
  };
  auto arguments = std::make_shared<Arguments>();
  auto* markdown = command->add_flag("--markdown", arguments->markdown, "as Markdown tables");
  command->add_flag("--json", arguments->json, "as a JSON Schema, by which editors complete and check scenes")
      ->excludes(markdown);
  command->callback([arguments] {
    const Units units;
    if (arguments->json) {
      std::cout << jsonSchema(units);
    } else {
      std::cout << (arguments->markdown ? schemaMarkdown(units) : schemaText(units));
    }
  });
}

}  // namespace restenosis
