#include "app/ui/code/listing/rule_panel.h"

#include "app/model/listing/listing_names.h"
#include "app/model/listing/rule_code.h"
#include "app/model/run/rule_error.h"
#include "app/model/session/playback.h"
#include "app/model/session/run_editor.h"
#include "app/ui/actions/command.h"
#include "app/ui/code/listing/listing_editor.h"
#include "app/ui/code/listing/mistake_row.h"
#include "app/ui/dock/divider.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/theme/icon_button.h"
#include "sim/run/script/composed_interval.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace app {

namespace {

const QString ruleEffect = QStringLiteral("rule");

}

RulePanel::RulePanel(const OpenRun &run, RunEditor &changes, const Playback &playback, RuleCode &rule,
                     const Theme &theme, QWidget *parent)
    : QWidget(parent), m_run(run), m_changes(changes), m_playback(playback), m_rule(rule),
      m_editor(new ListingEditor(theme, ListingEditor::Kind::rule, {run, changes}, this)),
      m_mistake(new MistakeRow(this)), m_state(new QLabel(this)), m_switchOn(new QPushButton(this)),
      m_delete(m_actions.addButton("deleteRule", tr("Delete rule")))
{
    styleAsPanel(*this);
    QVBoxLayout *layout = makeColumn(this);
    layout->addWidget(m_editor, 1);
    layout->addWidget(m_mistake);
    layout->addWidget(makeFoot());
    setFocusProxy(m_editor);
    showIcon(*m_delete, "close", theme);
    connect(m_delete, &QToolButton::clicked, this, [this] {
        m_editor->dropPending();
        m_rule.remove();
    });
    connect(m_editor, &ListingEditor::written, this, [this](const QString &text) { m_rule.write(text); });
    connect(m_editor, &ListingEditor::completionsWanted, this, [this](int line, int column) {
        m_editor->showCompletions(completionsAt(m_editor->text(), line, column, listing::ruleVocabulary()));
    });
    connect(m_editor, &ListingEditor::left, this, &RulePanel::left);
    connect(m_editor, &ListingEditor::resetRequested, m_delete, &QToolButton::click);
    run.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::cursor | ChangeKind::playing |
                     ChangeKind::code,
                 this, &RulePanel::follow);
    m_step = &run.step();
    refresh();
}

QWidget *RulePanel::makeFoot()
{
    auto *foot = new QWidget(this);
    m_state->setObjectName("caption");
    m_state->setWordWrap(true);
    m_switchOn->setText(tr("Switch on"));
    m_switchOn->setObjectName("switchRuleOn");
    m_switchOn->setToolTip(tr("Let your rule act again, from frame 0 on"));
    m_switchOn->setFocusPolicy(Qt::TabFocus);
    connect(m_switchOn, &QPushButton::clicked, this, [this] { m_changes.setEffect(ruleEffect, true); });
    auto *words = new QHBoxLayout;
    words->setContentsMargins(16, 8, 12, 4);
    words->setSpacing(12);
    words->addWidget(m_state, 1);
    words->addWidget(m_switchOn);
    m_commands = new QHBoxLayout;
    m_commands->setContentsMargins(12, 0, 12, 8);
    m_commands->setSpacing(6);
    m_commands->addStretch(1);
    QVBoxLayout *column = makeColumn(foot);
    column->addWidget(divider(foot));
    column->addLayout(words);
    column->addLayout(m_commands);
    return foot;
}

void RulePanel::addCommand(Command &command)
{
    auto *button = new QToolButton(this);
    button->setDefaultAction(&command);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize({16, 16});
    button->setFixedHeight(28);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(command.iconText());
    m_commands->insertWidget(m_commands->count() - 1, button);
}

RulePanel::~RulePanel()
{
    hide(); // ~QWidget() would do so when this panel can no longer follow its session
}

QString RulePanel::sentence() const
{
    return m_mistake->sentence();
}

QString RulePanel::state() const
{
    return m_state->text();
}

void RulePanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    refresh();
}

void RulePanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_editor->flush();
}

void RulePanel::follow(const Change &change)
{
    if (change.isAny(ChangeKind::step))
        m_editor->dropPending(); // it belongs to the step before
    if (change.isAny(ChangeKind::step | ChangeKind::run | ChangeKind::code)) {
        refresh();
        if (m_step != &m_run.step())
            m_editor->showTop();
        m_step = &m_run.step();
        return;
    }
    if (isVisible() && !m_playback.isPlaying())
        showMistakes();
}

void RulePanel::refresh()
{
    if (!m_rule.isOffered())
        return;
    m_editor->readParameters();
    const QString text = m_rule.text();
    if (!m_editor->isPending())
        m_editor->setListing(text);
    const bool isThere = text != RuleCode::startingText();
    m_delete->setEnabled(isThere);
    m_delete->setToolTip(isThere ? tr("Delete your rule and start over (Undo brings it back)")
                                 : tr("There is no rule yet."));
    m_switchOn->setVisible(m_rule.hasRule() && m_changes.isOff(ruleEffect));
    m_state->setText(stateText());
    showMistakes();
}

QString RulePanel::stateText() const
{
    if (!m_rule.hasRule())
        return tr("No rule acts yet. Your code acts as soon as you stop typing.");
    if (m_changes.isOff(ruleEffect))
        return tr("Your rule is switched off.");
    if (!m_rule.isActing())
        return tr("Your last rule without a mistake still acts.");
    const sim::Blueprint &plan = *m_changes.blueprint();
    QStringList words;
    if (plan.rule.program->hasForce())
        words << tr("force acts on every body.");
    if (plan.rule.program->hasPull())
        words << (plan.ruleLinks.empty() ? tr("pull acts along rule links, and there are none yet.")
                                         : tr("pull acts along %n rule links.", nullptr,
                                              static_cast<int>(plan.ruleLinks.size())));
    return words.join(' ');
}

void RulePanel::showMistakes()
{
    const std::vector<CodeMistake> mistakes = m_rule.mistakes();
    m_editor->setMistakes(mistakes);
    QString sentence = mistakeSentence(mistakes);
    LineMarks marks;
    if (const std::optional<listing::RuleError> error = m_rule.runError(); error && sentence.isEmpty()) {
        sentence = ruleMistakeSentence(*error, m_run.timeline().track().interval().scene);
        marks.failed = m_rule.isActing() ? error->error.line : 0;
    }
    m_editor->setMarks(marks);
    m_mistake->setSentence(sentence);
}

}
