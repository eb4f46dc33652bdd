#include "app/ui/actions/sandbox_commands.h"

#include "app/model/sandbox/sandbox.h"
#include "app/model/sandbox/sandbox_editor.h"
#include "app/ui/actions/command_list.h"

#include <QActionGroup>

namespace app {

SandboxCommands::SandboxCommands(Session &session, SandboxEditor &editor, CommandList &list)
    : take(list.add(tr("&Take this scene to the sandbox"), {QKeySequence("Ctrl+B")}, KeyGroup::build)),
      deleteChosen(list.add(tr("&Delete selection"), {QKeySequence("Del")}, KeyGroup::build)),
      duplicateChosen(list.add(tr("Dup&licate selection"), {QKeySequence("Ctrl+J")}, KeyGroup::build)),
      chooseAll(list.add(tr("Select &all"), {QKeySequence("Ctrl+A")}, KeyGroup::build)),
      rule(list.add(tr("&My rule"), {QKeySequence("R")}, KeyGroup::build)),
      linkChosen(list.add(tr("Lin&k selection by my rule"), {QKeySequence("Shift+L")}, KeyGroup::build)),
      m_session(session), m_editor(editor)
{
    take->setIconName("take");
    take->setHelp(tr("Continue building this scene in the sandbox"));
    rule->setIconText(tr("My rule"));
    rule->setIconName("rule");
    rule->setHelp(tr("Write a force of your own for this scene"));
    linkChosen->setIconText(tr("Link all"));
    linkChosen->setIconName("link-all");
    linkChosen->setHelp(tr("Add a rule link between each two of the selected points"));
    addTools(list);
    connect(take, &QAction::triggered, &session, [&session] { takeToSandbox(session); });
    connect(deleteChosen, &QAction::triggered, &editor, &SandboxEditor::eraseChosen);
    connect(duplicateChosen, &QAction::triggered, &editor, &SandboxEditor::duplicateChosen);
    connect(chooseAll, &QAction::triggered, &editor, &SandboxEditor::chooseAll);
    connect(linkChosen, &QAction::triggered, &editor, &SandboxEditor::addRuleLinksAmongChosen);
    session.onChange(ChangeKind::step, this, &SandboxCommands::follow);
    connect(&editor, &SandboxEditor::changed, this, &SandboxCommands::follow);
    follow();
}

void SandboxCommands::addTools(CommandList &list)
{
    addTool(list, BuildTool::select, tr("Select and move parts"), tr("Select"), "V",
            tr("Select parts, and drag them to another place"), "tool-select");
    addTool(list, BuildTool::point, tr("Add points"), tr("Point"), "P",
            tr("Add a body with a mass and a size"), "tool-point");
    addTool(list, BuildTool::nail, tr("Nail points down"), tr("Nail"), "N",
            tr("Fix a point in place, or free it"), "tool-nail");
    addTool(list, BuildTool::spring, tr("Add springs"), tr("Spring"), "S",
            tr("Connect two points with a spring, which pulls and pushes them to its length"), "tool-spring");
    addTool(list, BuildTool::stick, tr("Add sticks"), tr("Stick"), "T",
            tr("Connect two points with a stick, which keeps its length"), "tool-stick");
    addTool(list, BuildTool::foot, tr("Add feet"), tr("Foot"), "F",
            tr("Give a body a foot, at an angle from the body"), "tool-foot");
    addTool(list, BuildTool::ruleLink, tr("Add rule links"), tr("Rule link"), "L",
            tr("Connect two points by the function pull of your rule"), "tool-rule-link");
    auto *group = new QActionGroup(this);
    for (Command *tool : m_tools)
        group->addAction(tool);
}

void SandboxCommands::addTool(CommandList &list, BuildTool tool, const QString &text, const QString &name,
                              const char *key, const QString &help, const char *icon)
{
    Command *made = list.add(text, {QKeySequence(key)}, KeyGroup::build);
    made->setIconText(name);
    made->setIconName(icon);
    made->setHelp(help);
    made->setCheckable(true);
    connect(made, &QAction::triggered, this, [this, tool] { m_editor.setTool(tool); });
    m_tools << made;
}

void SandboxCommands::follow()
{
    const bool isOpen = m_session.isSandbox();
    for (Command *command : {deleteChosen, duplicateChosen, chooseAll, rule, linkChosen})
        command->setEnabled(isOpen);
    for (int i = 0; i < m_tools.size(); ++i) {
        m_tools[i]->setEnabled(isOpen);
        m_tools[i]->setChecked(static_cast<int>(m_editor.tool()) == i);
    }
    take->setObstacle(!sandboxOf(m_session.library()) ? tr("The sandbox is not installed")
                      : isOpen                        ? tr("This scene is already in the sandbox")
                                                      : QString());
}

}
