#include "app/ui/sandbox/build_panel.h"

#include "app/model/sandbox/build_guide.h"
#include "app/model/sandbox/sandbox.h"
#include "app/ui/actions/commands.h"
#include "app/ui/actions/sandbox_commands.h"
#include "app/ui/dock/divider.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/dock/scroll_page.h"
#include "app/ui/learn/after/project_box.h"
#include "app/ui/sandbox/effect_switches.h"
#include "app/ui/sandbox/example_gallery.h"
#include "app/ui/sandbox/guide_box.h"
#include "app/ui/sandbox/guide_ring.h"
#include "app/ui/sandbox/name_row.h"
#include "app/ui/sandbox/property_row.h"
#include "app/ui/theme/icons.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int sideMargin = 16;
constexpr int toolColumns = 3;
constexpr int leastSeen = 140; ///< px of the properties of a pressed part that come into view
constexpr int seenAround = 40; ///< px that stay visible above and below the control that the guide asks for

/// Makes a button that triggers `command` and is shown pressed while the command is checked.
QToolButton *toolButton(Command *command, const Theme &theme, QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setObjectName("tool");
    button->setDefaultAction(command);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize({20, 20});
    button->setFixedHeight(48);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(command->iconText());
    const auto applyTheme = [command, &theme] {
        const Tokens &t = theme.tokens();
        command->setIcon(iconOf(command->iconName(), t.ink2, t.onSunk));
    };
    applyTheme();
    QObject::connect(&theme, &Theme::changed, button, applyTheme);
    return button;
}

}

BuildPanel::BuildPanel(const OpenRun &run, RunEditor &changes, Playback &playback, SandboxEditor &editor,
                       BuildGuide &guide, const SandboxCommands &build, const Commands &commands,
                       const Theme &theme, QWidget *parent)
    : QWidget(parent), m_run(run), m_changes(changes), m_playback(playback), m_editor(editor), m_guide(guide),
      m_theme(theme), m_title(new PanelTitle(tr("Build"), theme, this, PanelTitle::CaptionPlace::right)),
      m_guideBox(new GuideBox(guide, this)), m_ring(new GuideRing(theme)),
      m_gallery(new ExampleGallery(run, changes, theme, this))
{
    styleAsPanel(*this);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 4, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(palette(build));
    column->addWidget(divider(this));
    column->addWidget(m_guideBox);
    column->addWidget(page(*commands.run.restart), 1);
    column->addWidget(divider(this));
    column->addWidget(feet(*commands.view.learn));
    connect(&editor, &SandboxEditor::changed, this, &BuildPanel::refresh);
    run.onChange(ChangeKind::step | ChangeKind::run, this, &BuildPanel::refresh);
    run.onChange(ChangeKind::cursor | ChangeKind::playing, this, [this] {
        if (m_editor.isOpen() && !m_editor.canBuild())
            refreshProperties(); // its text depends on the frame and on playback
    });
    connect(&guide, &BuildGuide::changed, this, &BuildPanel::refresh);
    refresh();
}

BuildPanel::~BuildPanel()
{
    delete m_ring; // its parent may have changed
}

QWidget *BuildPanel::palette(const SandboxCommands &build)
{
    auto *box = new QWidget(this);
    auto *grid = new QGridLayout(box);
    grid->setContentsMargins(12, 0, 12, 8);
    grid->setSpacing(4);
    int place = 0;
    const auto add = [&](Command *command) {
        QToolButton *button = toolButton(command, m_theme, box);
        grid->addWidget(button, place / toolColumns, place % toolColumns);
        ++place;
        return button;
    };
    for (Command *tool : build.tools())
        m_tools << add(tool);
    add(build.linkChosen);
    add(build.rule);
    return box;
}

QLabel *BuildPanel::heading(const QString &text)
{
    auto *label = new QLabel(text, this);
    label->setObjectName("heading");
    label->setContentsMargins(sideMargin, 10, sideMargin, 2);
    return label;
}

QWidget *BuildPanel::page(const Command &restart)
{
    m_area = makeScrollArea(*this);
    QWidget *content = makePage();
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 8);
    column->setSpacing(0);
    column->setSizeConstraint(QLayout::SetMinimumSize); // the page scrolls instead of squeezing its rows
    m_hint = makeTextLabel({}, {}, content);
    m_hint->setContentsMargins(sideMargin, 10, sideMargin, 6);
    m_away = new QWidget(content);
    auto *start = new QPushButton(tr("Go to the start"), m_away);
    start->setToolTip(withKeys(tr("Go to frame 0, where the scene can be changed"), restart.shortcut()));
    start->setFocusPolicy(Qt::TabFocus);
    connect(start, &QPushButton::clicked, this, [this] {
        m_playback.pause();
        m_changes.restart();
    });
    auto *row = new QHBoxLayout(m_away);
    row->setContentsMargins(sideMargin, 0, sideMargin, 8);
    row->addWidget(start);
    row->addStretch(1);
    m_properties = new QWidget(content);
    m_column = new QVBoxLayout(m_properties);
    m_column->setContentsMargins(0, 0, 0, 4);
    m_column->setSpacing(0);
    column->addWidget(m_hint);
    column->addWidget(m_away);
    column->addWidget(m_properties);
    column->addWidget(heading(tr("Effects on everything")));
    m_effects = new EffectSwitches(m_run, m_editor, content);
    column->addWidget(m_effects);
    column->addWidget(beginning(content));
    column->addStretch(1);
    m_area->setWidget(content);
    return m_area;
}

QWidget *BuildPanel::beginning(QWidget *parent)
{
    m_begin = new QWidget(parent);
    auto *row = new QHBoxLayout(m_begin);
    row->setContentsMargins(sideMargin, 12, sideMargin, 4);
    auto *button = new QPushButton(tr("First build: a walker"), m_begin);
    button->setObjectName("firstBuild");
    button->setToolTip(
        tr("Build a creature that walks, in ten clicks. It starts with a new scene. Undo brings yours back"));
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QPushButton::clicked, &m_guide, &BuildGuide::start);
    row->addWidget(button);
    row->addStretch(1);
    return m_begin;
}

QWidget *BuildPanel::feet(const Command &learn)
{
    auto *box = new QWidget(this);
    auto *row = new QHBoxLayout(box);
    row->setContentsMargins(8, 8, 8, 10); // there is no more room beside Measure
    row->setSpacing(6);
    const auto add = [&](const QString &text, const QString &tip, auto slot) {
        auto *button = new QPushButton(text, box);
        button->setToolTip(tip);
        button->setFocusPolicy(Qt::TabFocus);
        connect(button, &QPushButton::clicked, this, slot);
        row->addWidget(button);
        return button;
    };
    QPushButton *examples = add(tr("Examples"), tr("Scenes to start from. Undo brings yours back"), [] {});
    examples->setObjectName("examples");
    connect(examples, &QPushButton::clicked, this, [this, examples] { m_gallery->popUp(*examples); });
    add(tr("New"), tr("A scene with one point. Undo brings yours back"),
        [this] { startEmpty(m_run, m_changes); });
    row->addStretch(1);
    add(tr("Lessons"), withKeys(tr("Back to the lessons; your scene stays here"), learn.shortcut()),
        [this] { emit leaving(); });
    return box;
}

void BuildPanel::showProject(ProjectDesk &desk)
{
    QWidget *page = m_area->widget();
    static_cast<QVBoxLayout *>(page->layout())
        ->insertWidget(0, new ProjectBox(m_run, desk, ProjectBox::Shows::current, m_theme, page));
}

QString BuildPanel::hint() const
{
    return m_hint->text();
}

void BuildPanel::refresh()
{
    if (m_editor.isOpen()) {
        refreshTitle();
        refreshProperties();
    }
    pointOut(); // also hides the ring if no sandbox is open
}

QWidget *BuildPanel::targetControl() const
{
    const auto rowOf = [this](const QString &id) -> QWidget * {
        const auto found = std::find_if(m_rows.begin(), m_rows.end(), [&](const PropertyRow *one) {
            return one->property().about.id == id;
        });
        return found == m_rows.end() ? nullptr : *found;
    };
    switch (m_guide.step()) {
    case BuildGuide::Step::footTool:
        return m_tools.value(static_cast<int>(BuildTool::foot));
    case BuildGuide::Step::chooseTool:
        return m_tools.value(static_cast<int>(BuildTool::select));
    case BuildGuide::Step::swing:
        return rowOf(QStringLiteral("speed"));
    case BuildGuide::Step::ground:
        return m_effects->box(QStringLiteral("ground"));
    case BuildGuide::Step::walls:
        return m_effects->box(QStringLiteral("walls"));
    case BuildGuide::Step::play:
        return window()->findChild<QToolButton *>(QStringLiteral("play"));
    default:
        return nullptr; // the target is in the scene
    }
}

void BuildPanel::pointOut()
{
    m_begin->setVisible(!m_guide.isOn());
    if (!m_ring)
        return; // the window is being closed
    QWidget *target = m_guide.isOn() && m_editor.isOpen() ? targetControl() : nullptr;
    m_ring->setWidget(target);
    auto *field = qobject_cast<QAbstractSpinBox *>(QApplication::focusWidget());
    if (target && m_guide.step() == BuildGuide::Step::play && isAncestorOf(field))
        field->clearFocus(); // otherwise Space would go to the field and not start playback
    if (!target || !m_area->isAncestorOf(target))
        return;
    QTimer::singleShot(0, target, [this, target] { // after the layout is done
        m_area->ensureWidgetVisible(target, 0, seenAround);
        if (!m_ring || m_ring->widget() != target)
            return;
        m_ring->setWidget(nullptr); // a ring that was scrolled out of view stays hidden otherwise
        m_ring->setWidget(target);
    });
}

void BuildPanel::refreshTitle()
{
    const sim::Blueprint &plan = m_editor.plan();
    const std::size_t links =
        plan.springs.size() + plan.sticks.size() + plan.feet.size() + plan.ruleLinks.size();
    m_title->setCaption(tr("points %1, links %2").arg(plan.points.size()).arg(links));
}

QString BuildPanel::waitHint() const
{
    if (m_playback.isPlaying())
        return tr("The scene is playing. You can only build at the start of the run.");
    return tr("You are at frame %1. You can only build at the start of the run.")
        .arg(m_run.timeline().cursor().frame);
}

QString BuildPanel::toolHint() const
{
    if (m_editor.first())
        return m_editor.tool() == BuildTool::foot
                   ? tr("Click each of its feet, or where you want one. Esc: another body.")
                   : tr("Click where it ends; the next one starts there. Esc: start somewhere else.");
    switch (m_editor.tool()) {
    case BuildTool::point:
        return tr("Click where you want a point.");
    case BuildTool::nail:
        return tr("Click a point to nail it down or to free it, or click where you want a nail.");
    case BuildTool::spring:
        return tr("Drag from point to point to make one spring. With clicks, each spring starts where the "
                  "last one ends.");
    case BuildTool::stick:
        return tr("Drag from point to point to make one stick. With clicks, each stick starts where the last "
                  "one ends.");
    case BuildTool::foot:
        return tr("Click a body, then each of its feet, or where you want one.");
    case BuildTool::ruleLink:
        return tr("Drag from point to point to make one rule link, along which pull of your rule acts. With "
                  "clicks, each link starts where the last one ends.");
    case BuildTool::select:
        if (!m_editor.chosen().ruleLinks.empty())
            return tr("A rule link has no settings: pull of your rule acts on both of its ends.");
        break;
    }
    return tr("Click a part to select it, drag it to move it, or draw a box around several.");
}

void BuildPanel::refreshProperties()
{
    const bool can = m_editor.canBuild();
    std::vector<SandboxProperty> properties;
    if (can)
        properties = propertiesOf(m_editor.plan(), m_editor.chosen(), m_run.step().availableEffects);
    const bool any = !properties.empty();
    m_away->setVisible(!can);
    const bool isGuided = m_guide.isOn() && can; // the guide gives one instruction at a time
    m_hint->setVisible(!isGuided && (!any || m_editor.tool() != BuildTool::select));
    m_properties->setVisible(any);
    m_hint->setText(can ? toolHint() : waitHint());
    if (!any) {
        if (!m_rows.empty())
            makeRows({}); // the rows refer to parts by index
        m_shownKey.clear();
        return;
    }
    const QString key = keyOf(properties);
    if (key != m_shownKey) {
        m_shownKey = key;
        makeRows(std::move(properties));
    } else {
        showSections(properties);
    }
    if (m_name)
        m_name->refresh();
    for (PropertyRow *row : m_rows)
        row->refresh();
}

void BuildPanel::showProperties()
{
    QTimer::singleShot(0, m_properties, [this] { // after the layout is done
        QScrollBar *bar = m_area->verticalScrollBar();
        const int top = m_properties->y(), below = bar->value() + m_area->viewport()->height();
        if (below - top < std::min(m_properties->height(), leastSeen))
            bar->setValue(top);
    });
}

QString BuildPanel::keyOf(const std::vector<SandboxProperty> &properties) const
{
    const sim::Blueprint &plan = m_editor.plan();
    QStringList key;
    if (const std::vector<int> &points = m_editor.chosen().points; points.size() == 1) {
        key << QString::number(points.front());
        if (const std::optional<int> foot = footOf(plan, points.front()))
            key << QString::number(*foot) << QString::number(plan.feet[std::size_t(*foot)].gait);
    }
    for (const SandboxProperty &one : properties)
        key << one.about.id + QString::number(one.about.max);
    return key.join(' ');
}

void BuildPanel::showSections(const std::vector<SandboxProperty> &properties)
{
    std::size_t headings = 0;
    for (std::size_t i = 0; i < properties.size(); ++i) {
        const QString &section = properties[i].section;
        m_rows[i]->setSection(section);
        if (i == 0 && m_name)
            m_name->setSection(section);
        if (i == 0 || section != properties[i - 1].section)
            m_headings[headings++]->setText(section);
    }
}

void BuildPanel::clearRows()
{
    if (m_ring)
        m_ring->setWidget(nullptr); // the ring may be round one of the rows
    if (m_name)
        m_name->discard();
    m_name = nullptr;
    // Deleted later, because the signal that led here may have come from one of these rows.
    while (QLayoutItem *item = m_column->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    m_rows.clear();
    m_headings.clear();
}

void BuildPanel::makeRows(std::vector<SandboxProperty> properties)
{
    clearRows();
    QString section;
    bool hasFoot = false;
    for (SandboxProperty &one : properties) {
        if (one.section != section) {
            m_headings.push_back(heading(one.section));
            m_column->addWidget(m_headings.back());
        }
        if (section.isEmpty() && m_editor.chosen().points.size() == 1) {
            m_name = new NameRow(m_editor, m_editor.chosen().points.front(), one.section, m_properties);
            m_column->addWidget(m_name);
        }
        section = one.section;
        hasFoot = hasFoot || one.about.id == QStringLiteral("gait");
        m_rows.push_back(new PropertyRow(m_editor, std::move(one), m_theme, m_properties));
        m_column->addWidget(m_rows.back());
    }
    if (hasFoot)
        makeGaitHelp();
}

void BuildPanel::makeGaitHelp()
{
    QLabel *said = makeTextLabel(
        "caption", tr("On the ground, Swing makes it walk. Opposite feet need opposite angles: 0° and 180°."),
        m_properties);
    said->setContentsMargins(sideMargin, 6, sideMargin, 2);
    m_column->addWidget(said);
    auto *box = new QWidget(m_properties);
    auto *row = new QHBoxLayout(box);
    row->setContentsMargins(sideMargin, 4, sideMargin, 4);
    auto *button = new QPushButton(tr("New gait group"), box);
    button->setToolTip(tr("Gives this foot its own gait group, with its own clock"));
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QPushButton::clicked, this, [this] {
        const std::vector<int> points = m_editor.chosen().points;
        const std::optional<int> foot =
            points.size() == 1 ? footOf(m_editor.plan(), points.front()) : std::nullopt;
        if (foot)
            m_editor.addGaitFor(*foot);
    });
    row->addWidget(button);
    row->addStretch(1);
    m_column->addWidget(box);
}

}
