#include "app/ui/code/stop_list.h"

#include "app/model/code_listing.h"
#include "app/model/refusal.h"
#include "app/ui/theme/theme.h"
#include "sim/run/script/composed_interval.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int rowHeight = 32;
constexpr int mostRows = 3; ///< seen at once; more scroll

QString placeText(const Breakpoint &breakpoint)
{
    return breakpoint.place
               ? QStringLiteral("%1:%2").arg(fileName(breakpoint.place->file)).arg(breakpoint.place->line)
               : StopList::tr("when");
}

}

StopList::StopList(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_theme(theme), m_scroll(new QScrollArea(this)),
      m_field(new QLineEdit(this)), m_refusal(new QLabel(this))
{
    setObjectName("panel");
    setAttribute(Qt::WA_StyledBackground);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_refusal->setObjectName("failure");
    m_refusal->setWordWrap(true);
    m_refusal->setContentsMargins(12, 0, 12, 6);
    m_refusal->hide();
    m_field->setObjectName("stopWhen");
    m_field->setAccessibleName(tr("Stop when"));
    m_field->setToolTip(tr("Stops the run as soon as this comes true, also inside a frame.\n"
                           "There are x, y, vx, vy of bodies, frame, phase, and all parameters;\n"
                           "+ - * / ( ), < <= > >= == !=, and, or, not, abs(), sqrt().\n"
                           "Enter adds it."));
    m_field->setAccessibleDescription(m_field->toolTip());
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto *line = new QFrame(this);
    line->setObjectName("divider");
    line->setFixedHeight(1);
    column->addWidget(line);
    column->addWidget(m_scroll);
    auto *box = new QHBoxLayout;
    box->setContentsMargins(12, 4, 12, 6);
    box->addWidget(m_field);
    column->addLayout(box);
    column->addWidget(m_refusal);
    connect(m_field, &QLineEdit::returnPressed, this, &StopList::addFromField);
    connect(m_field, &QLineEdit::textEdited, this, [this] { say({}); });
    connect(&session.breakpoints(), &Breakpoints::changed, this, &StopList::rebuild, Qt::QueuedConnection);
    connect(&session, &Session::stepOpened, this, &StopList::rebuild);
    connect(&session, &Session::runChanged, this, &StopList::suggest); // what is built may have other bodies
    connect(&theme, &Theme::changed, this, &StopList::dress);
    dress();
}

void StopList::dress()
{
    m_field->setFont(m_theme.mono(12));
    m_shown.clear();
    rebuild();
}

QString StopList::refusal() const
{
    return m_refusal->isHidden() ? QString() : m_refusal->text();
}

void StopList::say(const QString &refusal)
{
    m_refusal->setText(refusal);
    m_refusal->setVisible(!refusal.isEmpty());
}

bool StopList::accepts(const QString &text)
{
    try {
        Condition::parse(text, conditionNames(m_session.step(), m_session.timeline()));
    } catch (const Refusal &refusal) {
        say(refusal.sentence());
        return false;
    }
    say({});
    return true;
}

void StopList::addFromField()
{
    const QString text = m_field->text().trimmed();
    if (text.isEmpty()) {
        say({});
        return;
    }
    if (!accepts(m_field->text()))
        return;
    m_field->clear();
    m_session.breakpoints().add(text);
}

void StopList::setCondition(int id, QLineEdit *edit)
{
    const Breakpoint *breakpoint = m_session.breakpoints().find(id);
    const QString text = edit->text().trimmed();
    if (!breakpoint || text == breakpoint->condition)
        return;
    const bool mayBeEmpty = breakpoint->place.has_value();
    if ((text.isEmpty() && mayBeEmpty) || accepts(edit->text()))
        m_session.breakpoints().setCondition(id, text);
}

QLineEdit *StopList::conditionOf(const Breakpoint &breakpoint, QWidget *row)
{
    auto *edit = new QLineEdit(breakpoint.condition, row);
    edit->setObjectName(QStringLiteral("condition%1").arg(breakpoint.id));
    edit->setFont(m_theme.mono(12));
    edit->setPlaceholderText(tr("always, or when…"));
    edit->setAccessibleName(tr("Condition of the stop %1").arg(placeText(breakpoint)));
    edit->setToolTip(breakpoint.place
                         ? tr("Stops before this line's phase where this holds. Enter keeps what you typed.")
                         : tr("Stops where this comes true. Enter keeps what you typed."));
    connect(edit, &QLineEdit::editingFinished, this,
            [this, id = breakpoint.id, edit] { setCondition(id, edit); });
    return edit;
}

QWidget *StopList::rowFor(const Breakpoint &breakpoint)
{
    auto *row = new QWidget(m_rows);
    row->setFixedHeight(rowHeight);
    auto *box = new QHBoxLayout(row);
    box->setContentsMargins(12, 0, 8, 0);
    box->setSpacing(8);
    const int id = breakpoint.id;
    auto *on = new QCheckBox(placeText(breakpoint), row);
    on->setChecked(breakpoint.isOn);
    on->setObjectName(QStringLiteral("on%1").arg(id));
    on->setToolTip(breakpoint.place ? tr("Whether to stop before this line (%1)").arg(breakpoint.place->file)
                                    : tr("Whether to stop when this comes true"));
    on->setAccessibleName(tr("Stop %1 %2").arg(placeText(breakpoint), breakpoint.condition).trimmed());
    auto *remove = new QToolButton(row);
    remove->setIcon(m_theme.icon(QStringLiteral("close")));
    remove->setIconSize({14, 14});
    remove->setObjectName(QStringLiteral("remove%1").arg(id));
    remove->setToolTip(tr("Take this stop away"));
    remove->setAccessibleName(
        tr("Take the stop %1 %2 away").arg(placeText(breakpoint), breakpoint.condition));
    box->addWidget(on);
    box->addWidget(conditionOf(breakpoint, row), 1);
    box->addWidget(remove);
    connect(on, &QCheckBox::toggled, this, [this, id](bool checked) {
        if (const Breakpoint *one = m_session.breakpoints().find(id); checked && one && one->place)
            emit chosen(*one->place);
        m_session.breakpoints().setOn(id, checked);
    });
    connect(remove, &QToolButton::clicked, this, [this, id] { m_session.breakpoints().remove(id); });
    return row;
}

void StopList::suggest()
{
    const sim::Scene &scene = m_session.timeline().track().interval().scene;
    m_field->setPlaceholderText(
        tr("Stop when… (%1.y > 300)").arg(QString::fromStdString(scene.names.front())));
}

void StopList::rebuild()
{
    suggest();
    const std::vector<Breakpoint> &all = m_session.breakpoints().all();
    const auto sameRow = [](const Breakpoint &a, const Breakpoint &b) {
        return a.id == b.id && a.condition == b.condition;
    };
    if (m_rows && std::equal(all.begin(), all.end(), m_shown.begin(), m_shown.end(), sameRow)) {
        // The keyboard may be in one of the rows: they stay.
        for (const Breakpoint &one : all)
            m_rows->findChild<QCheckBox *>(QStringLiteral("on%1").arg(one.id))->setChecked(one.isOn);
        m_shown = all;
        return;
    }
    const QWidget *focus = m_rows ? m_rows->focusWidget() : nullptr;
    const QString name = focus && focus->hasFocus() ? focus->objectName() : QString();
    if (!name.isEmpty())
        m_field->setFocus(Qt::OtherFocusReason); // what is being typed is taken before its field goes
    m_shown = all;
    m_rows = new QWidget;
    m_rows->setObjectName("panel");
    auto *column = new QVBoxLayout(m_rows);
    column->setContentsMargins(0, 4, 0, 0);
    column->setSpacing(0);
    for (const Breakpoint &one : all)
        column->addWidget(rowFor(one));
    m_scroll->setWidget(m_rows); // takes the old rows away
    m_scroll->setFixedHeight(4 + rowHeight * std::min(mostRows, static_cast<int>(all.size())));
    m_scroll->setVisible(!all.empty());
    if (!name.isEmpty()) {
        QWidget *same = m_rows->findChild<QWidget *>(name);
        (same ? same : m_field)->setFocus(Qt::OtherFocusReason);
    }
}

void StopList::edit(int id)
{
    rebuild();
    if (auto *edit = m_rows->findChild<QLineEdit *>(QStringLiteral("condition%1").arg(id))) {
        m_scroll->ensureWidgetVisible(edit);
        edit->setFocus(Qt::ShortcutFocusReason);
        edit->selectAll();
    }
}

}
