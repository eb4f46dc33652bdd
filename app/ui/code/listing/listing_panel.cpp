#include "app/ui/code/listing/listing_panel.h"

#include "app/model/listing/changed_lines.h"
#include "app/model/listing/line_of_code.h"
#include "app/model/listing/line_values.h"
#include "app/model/listing/listing_names.h"
#include "app/model/run/run_program.h"
#include "app/ui/code/breakpoint_list.h"
#include "app/ui/code/listing/listing_editor.h"
#include "app/ui/code/listing/mistake_row.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/theme/icon_button.h"

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int rowMargin = 16;

}

ListingPanel::ListingPanel(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_calls(new QLabel(this)),
      m_editor(
          new ListingEditor(theme, ListingEditor::Kind::listing, {session.run(), session.editor()}, this)),
      m_mistake(new MistakeRow(this)),
      m_stops(new BreakpointList(session.run(), session.playback(), theme, this)),
      m_reset(m_actions.addButton("resetListing", tr("Reset listing")))
{
    styleAsPanel(*this);
    m_calls->setObjectName("caption");
    m_calls->setFont(theme.mono(12));
    m_calls->setTextFormat(Qt::PlainText);
    m_calls->setWordWrap(true);
    m_calls->hide();
    QVBoxLayout *layout = makeColumn(this);
    auto *above = new QVBoxLayout;
    above->setContentsMargins(rowMargin, 0, rowMargin, 4);
    above->addWidget(m_calls);
    layout->addLayout(above);
    layout->addWidget(m_editor, 1);
    layout->addWidget(m_mistake);
    layout->addWidget(m_stops);
    connect(m_stops, &BreakpointList::chosen, this, &ListingPanel::placeChosen);
    setFocusProxy(m_editor);
    showIcon(*m_reset, "reset", theme);
    connect(m_reset, &QToolButton::clicked, this, [this] {
        m_editor->dropPending();
        m_session.code().reset();
    });
    connectEditor();
    session.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::cursor | ChangeKind::playing |
                         ChangeKind::preview | ChangeKind::code,
                     this, &ListingPanel::follow);
    m_step = &session.step();
    refresh();
}

ListingPanel::~ListingPanel()
{
    hide(); // ~QWidget() would do so when this panel can no longer follow its session
}

void ListingPanel::connectEditor()
{
    connect(m_editor, &ListingEditor::written, &m_session.code(), &LearnerCode::write);
    connect(m_editor, &ListingEditor::completionsWanted, this, [this](int line, int column) {
        m_editor->showCompletions(
            completionsAt(m_editor->text(), line, column, m_session.code().vocabulary()));
    });
    connect(m_editor, &ListingEditor::runRequested, this, [this](int line) {
        if (m_session.lines().isAvailable())
            m_session.lines().runTo(line);
        else
            m_session.showMessage(
                m_session.code().isInUse()
                    ? tr("Correct the mistake first. Until then, the last good code computes the run.")
                    : tr("This listing does not compute the run. Choose “Use your code” first."));
    });
    connect(m_editor, &ListingEditor::stopRequested, this, &ListingPanel::toggleStop);
    connect(&m_session.playback().breakpoints(), &Breakpoints::changed, this, &ListingPanel::showStops);
    connect(m_editor, &ListingEditor::pointedAt, this, &ListingPanel::pointAt);
    connect(m_editor, &ListingEditor::left, this, &ListingPanel::left);
    connect(m_editor, &ListingEditor::resetRequested, m_reset, &QToolButton::click);
}

QString ListingPanel::sentence() const
{
    return m_mistake->sentence();
}

QString ListingPanel::calls() const
{
    return m_calls->isHidden() ? QString() : m_calls->text();
}

void ListingPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    refresh();
}

void ListingPanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_editor->flush();
    pointAt(std::nullopt);
}

void ListingPanel::follow(const Change &change)
{
    if (change.isAny(ChangeKind::step)) {
        m_editor->dropPending(); // it belongs to the step before
        pointAt(std::nullopt);
    }
    if (change.isAny(ChangeKind::step | ChangeKind::run | ChangeKind::code)) {
        refresh();
        if (m_step != &m_session.step()) {
            m_editor->showTop();
            if (m_editor->hasFocus())
                emit left(); // Space should play the new step, not write into its listing
        }
        m_step = &m_session.step();
        return;
    }
    if (!isVisible() || !m_pace.isDue())
        return;
    showMistakes();
    showValues();
}

void ListingPanel::refresh()
{
    showText();
    showMistakes();
    showValues();
    showStops();
}

void ListingPanel::showStops()
{
    std::vector<LineStop> stops;
    for (const Breakpoint &one : m_session.playback().breakpoints().all()) {
        if (one.place && one.place->isInListing())
            stops.push_back({one.place->line, one.isOn, !one.condition.isEmpty()});
    }
    m_editor->setStops(std::move(stops));
}

void ListingPanel::toggleStop(int line)
{
    Breakpoints &breakpoints = m_session.playback().breakpoints();
    const bool isSet = breakpoints.at({{}, line});
    const int place = isSet ? line : lineOfCodeFrom(m_editor->text(), line);
    if (place == 0) {
        m_session.showMessage(
            tr("No line that runs comes after line %1. Choose a line inside a function.").arg(line));
        return;
    }
    if (isSet || !breakpoints.at({{}, place}))
        breakpoints.toggle({{}, place});
    m_session.showMessage(isSet ? tr("No longer stops before line %1.").arg(place)
                                : tr("Stops before line %1.").arg(place));
}

void ListingPanel::showText()
{
    const LearnerCode &code = m_session.code();
    m_editor->readParameters();
    if (!m_editor->isPending())
        m_editor->setListing(code.text());
    m_editor->setChangedLines(changedLines(code.original(), code.text()));
    m_reset->setEnabled(code.isChanged());
    m_reset->setToolTip(code.isChanged() ? tr("Bring the step's own listing back (Undo brings yours back)")
                                         : tr("This is the step's own listing."));
}

void ListingPanel::showMistakes()
{
    const LearnerCode &code = m_session.code();
    const std::vector<CodeMistake> mistakes = code.mistakes();
    m_editor->setMistakes(mistakes);
    QString sentence = mistakeSentence(mistakes);
    if (const std::optional<listing::RunError> error = code.runError(); error && sentence.isEmpty())
        sentence = mistakeSentence(*error);
    m_mistake->setSentence(sentence);
}

void ListingPanel::showValues()
{
    m_pace.restart();
    const LineStepper &lines = m_session.lines();
    const LineStepper::Shown shown = lines.shown();
    const bool isPlaying = m_session.playback().isPlaying();
    LineValues values = shown.frame ? valuesAfter(*shown.frame, shown.index) : LineValues();
    LineMarks marks;
    if (!isPlaying && lines.isAvailable()) {
        marks.next = lines.nextLine();
        marks.isInside = lines.index() > 0;
        if (const std::optional<listing::RunError> error = m_session.code().runError())
            marks.failed = error->line;
    }
    if (isPlaying) {
        for (LineChip &chip : values.chips)
            chip.isChanged = false; // the marks would flicker
    }
    const QString calls = values.calls.size() > 1 ? values.calls.join(QStringLiteral(" › ")) : QString();
    m_calls->setText(calls);
    m_calls->setVisible(!calls.isEmpty() && !isPlaying);
    m_editor->setMarks(marks);
    m_editor->setValues(std::move(values));
    showUses();
    if (m_pointed)
        pointAt(m_pointed);
}

void ListingPanel::showUses()
{
    if (m_pointedBody.isEmpty()) {
        m_editor->setUses({});
        return;
    }
    const LineStepper::Shown shown = m_session.lines().shown();
    m_editor->setUses(usesOf(m_editor->text(), m_pointedBody, m_session.code().vocabulary(),
                             shown.frame.get(), shown.index));
}

void ListingPanel::setPointedBody(const QString &body)
{
    if (body == m_pointedBody)
        return;
    m_pointedBody = body;
    if (isVisible())
        showUses();
}

void ListingPanel::pointAt(const std::optional<TextRange> &place)
{
    m_pointed = place;
    LineStepper::Shown shown = m_session.lines().shown();
    if (place && !shown.frame)
        shown = {m_session.lines().nextFrame(), 0, false};
    const bool isKnown = place && shown.frame && !m_session.playback().isPlaying();
    emit vectorPointedAt(
        isKnown ? vectorMarkAt(m_editor->text(), place->line, place->column, *shown.frame, shown.index)
                : std::nullopt);
}

}
