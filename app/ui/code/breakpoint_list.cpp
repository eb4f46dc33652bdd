#include "app/ui/code/breakpoint_list.h"

#include "app/model/code/code_listing.h"
#include "app/model/text/user_error.h"
#include "app/ui/dock/divider.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/theme/icon_button.h"
#include "sim/run/script/composed_interval.h"

#include <QCheckBox>
#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int rowHeight = 32;
constexpr int mostRows = 3; ///< visible rows; more can be scrolled to

/// A field for a condition. Text can be dropped on it; files are for the window.
class ConditionField : public QLineEdit
{
public:
    using QLineEdit::QLineEdit;

protected:
    void dragEnterEvent(QDragEnterEvent *event) override
    {
        if (event->mimeData()->hasUrls())
            event->ignore();
        else
            QLineEdit::dragEnterEvent(event);
    }
};

QString placeText(const Breakpoint &breakpoint)
{
    if (!breakpoint.place)
        return BreakpointList::tr("when");
    if (breakpoint.place->isInListing())
        return BreakpointList::tr("line %1").arg(breakpoint.place->line);
    return QStringLiteral("%1:%2").arg(fileName(breakpoint.place->file)).arg(breakpoint.place->line);
}

/// Returns what the breakpoint does, for the tooltip of its check box.
QString stopTip(const Breakpoint &breakpoint)
{
    if (!breakpoint.place)
        return BreakpointList::tr("Stop when this becomes true");
    return breakpoint.place->isInListing()
               ? BreakpointList::tr("Stop before this line of the listing")
               : BreakpointList::tr("Stop before this line (%1)").arg(breakpoint.place->file);
}

/// Returns what its condition does.
QString conditionTip(const Breakpoint &breakpoint)
{
    if (!breakpoint.place)
        return BreakpointList::tr("Stops when this becomes true. Press Enter to apply.");
    return breakpoint.place->isInListing()
               ? BreakpointList::tr("Stops before this line if this is true. Press Enter to apply.")
               : BreakpointList::tr("Stops before this line's phase if this is true. Press Enter to apply.");
}

}

BreakpointList::BreakpointList(const OpenRun &run, Playback &playback, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_run(run), m_playback(playback), m_theme(theme), m_scroll(new QScrollArea(this)),
      m_field(new ConditionField(this)), m_error(new QLabel(this))
{
    styleAsPanel(*this);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_error->setObjectName("failure");
    m_error->setWordWrap(true);
    m_error->setContentsMargins(12, 0, 12, 6);
    m_error->hide();
    m_field->setObjectName("stopWhen");
    m_field->setFont(theme.mono(12));
    m_field->setAccessibleName(tr("Stop when"));
    m_field->setToolTip(tr("Stops the run as soon as this is true, even inside a frame.\nYou can use x, y, "
                           "vx, vy of bodies, frame, phase, and all parameters;\n+ - * / ( ), < <= > >= == "
                           "!=, and, or, not, abs(), sqrt(), distance(a, b), speed(a), still(a), held(a), "
                           "released(a).\nPress Enter to "
                           "add it."));
    m_field->setAccessibleDescription(m_field->toolTip());
    QVBoxLayout *column = makeColumn(this);
    column->addWidget(divider(this));
    column->addWidget(m_scroll);
    auto *box = new QHBoxLayout;
    box->setContentsMargins(12, 4, 12, 6);
    box->addWidget(m_field);
    column->addLayout(box);
    column->addWidget(m_error);
    connect(m_field, &QLineEdit::returnPressed, this, &BreakpointList::addFromField);
    connect(m_field, &QLineEdit::textEdited, this, [this] { showError({}); });
    connect(&playback.breakpoints(), &Breakpoints::changed, this, &BreakpointList::rebuild,
            Qt::QueuedConnection);
    run.onChange(ChangeKind::step, this, &BreakpointList::rebuild);
    run.onChange(ChangeKind::run, this, &BreakpointList::suggest); // a sandbox may have other bodies now
    rebuild();
}

QString BreakpointList::errorText() const
{
    return m_error->isHidden() ? QString() : m_error->text();
}

void BreakpointList::showError(const QString &text)
{
    m_error->setText(text);
    m_error->setVisible(!text.isEmpty());
}

bool BreakpointList::accepts(const QString &text)
{
    try {
        Condition::parse(text, conditionNames(m_run.step(), m_run.timeline()));
    } catch (const UserError &error) {
        showError(error.sentence());
        return false;
    }
    showError({});
    return true;
}

void BreakpointList::addFromField()
{
    const QString text = m_field->text().trimmed();
    if (text.isEmpty()) {
        showError({});
        return;
    }
    if (!accepts(m_field->text()))
        return;
    m_field->clear();
    m_playback.breakpoints().add(text);
}

void BreakpointList::setCondition(int id, QLineEdit *edit)
{
    const Breakpoint *breakpoint = m_playback.breakpoints().find(id);
    const QString text = edit->text().trimmed();
    if (!breakpoint || text == breakpoint->condition)
        return;
    const bool mayBeEmpty = breakpoint->place.has_value();
    if ((text.isEmpty() && mayBeEmpty) || accepts(edit->text()))
        m_playback.breakpoints().setCondition(id, text);
}

QLineEdit *BreakpointList::conditionOf(const Breakpoint &breakpoint, QWidget *row)
{
    auto *edit = new ConditionField(breakpoint.condition, row);
    edit->setObjectName(QStringLiteral("condition%1").arg(breakpoint.id));
    edit->setFont(m_theme.mono(12));
    edit->setPlaceholderText(tr("always, or when…"));
    edit->setAccessibleName(tr("Condition of breakpoint %1").arg(placeText(breakpoint)));
    edit->setToolTip(conditionTip(breakpoint));
    connect(edit, &QLineEdit::editingFinished, this,
            [this, id = breakpoint.id, edit] { setCondition(id, edit); });
    return edit;
}

QWidget *BreakpointList::rowFor(const Breakpoint &breakpoint)
{
    auto *row = new QWidget(m_rows);
    row->setFixedHeight(rowHeight);
    auto *box = new QHBoxLayout(row);
    box->setContentsMargins(12, 0, 8, 0);
    box->setSpacing(8);
    const int id = breakpoint.id;
    auto *on = new QCheckBox(placeText(breakpoint), row);
    on->setChecked(breakpoint.isOn);
    on->setFocusPolicy(Qt::TabFocus);
    on->setObjectName(QStringLiteral("on%1").arg(id));
    on->setToolTip(stopTip(breakpoint));
    on->setAccessibleName(tr("Breakpoint %1 %2").arg(placeText(breakpoint), breakpoint.condition).trimmed());
    auto *remove = new QToolButton(row);
    showIcon(*remove, "close", m_theme);
    remove->setIconSize({14, 14});
    remove->setObjectName(QStringLiteral("remove%1").arg(id));
    remove->setToolTip(tr("Remove this breakpoint"));
    remove->setAccessibleName(
        tr("Remove the breakpoint %1 %2").arg(placeText(breakpoint), breakpoint.condition));
    box->addWidget(on);
    box->addWidget(conditionOf(breakpoint, row), 1);
    box->addWidget(remove);
    connect(on, &QCheckBox::toggled, this, [this, id](bool checked) {
        if (const Breakpoint *one = m_playback.breakpoints().find(id); checked && one && one->place)
            emit chosen(*one->place);
        m_playback.breakpoints().setOn(id, checked);
    });
    connect(remove, &QToolButton::clicked, this, [this, id] { m_playback.breakpoints().remove(id); });
    return row;
}

void BreakpointList::suggest()
{
    const sim::Scene &scene = m_run.timeline().track().interval().scene;
    m_field->setPlaceholderText(
        tr("Stop when… (%1.y > 300)").arg(QString::fromStdString(scene.names.front())));
}

void BreakpointList::rebuild()
{
    suggest();
    const std::vector<Breakpoint> &all = m_playback.breakpoints().all();
    const auto sameRow = [](const Breakpoint &a, const Breakpoint &b) {
        return a.id == b.id && a.condition == b.condition && a.place == b.place;
    };
    if (m_rows && std::equal(all.begin(), all.end(), m_shown.begin(), m_shown.end(), sameRow)) {
        // Keeps the rows, because one of them may have the keyboard focus.
        for (const Breakpoint &one : all)
            m_rows->findChild<QCheckBox *>(QStringLiteral("on%1").arg(one.id))->setChecked(one.isOn);
        m_shown = all;
        return;
    }
    const QWidget *focus = m_rows ? m_rows->focusWidget() : nullptr;
    const QString name = focus && focus->hasFocus() ? focus->objectName() : QString();
    // A row's field commits its text when it loses the focus, which must happen before it is deleted.
    if (!name.isEmpty())
        m_field->setFocus(Qt::OtherFocusReason);
    m_shown = all;
    m_rows = new QWidget;
    m_rows->setObjectName("panel");
    auto *column = new QVBoxLayout(m_rows);
    column->setContentsMargins(0, 4, 0, 0);
    column->setSpacing(0);
    for (const Breakpoint &one : all)
        column->addWidget(rowFor(one));
    m_scroll->setWidget(m_rows); // deletes the old rows
    m_scroll->setFixedHeight(4 + rowHeight * std::min(mostRows, static_cast<int>(all.size())));
    m_scroll->setVisible(!all.empty());
    if (!name.isEmpty()) {
        QWidget *same = m_rows->findChild<QWidget *>(name);
        (same ? same : m_field)->setFocus(Qt::OtherFocusReason);
    }
}

void BreakpointList::edit(int id)
{
    rebuild();
    if (auto *edit = m_rows->findChild<QLineEdit *>(QStringLiteral("condition%1").arg(id))) {
        m_scroll->ensureWidgetVisible(edit);
        edit->setFocus(Qt::ShortcutFocusReason);
        edit->selectAll();
    }
}

}
