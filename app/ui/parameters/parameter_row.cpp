#include "app/ui/parameters/parameter_row.h"

#include "app/model/text/numbers.h"
#include "app/ui/dock/panel_parts.h"
#include "sim/run/script/composed_interval.h"

#include "app/ui/parameters/grouped_choice.h"
#include "app/ui/parameters/number_box.h"
#include "app/ui/parameters/parameter_slider.h"
#include "app/ui/theme/icon_button.h"
#include "lessons/api/parameter.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QToolButton>

#include <algorithm>

namespace app {

namespace {

constexpr int leftMargin = 16;
constexpr int rightMargin = 13;
constexpr int besideBrief = 8;
constexpr int unitGap = 8;
constexpr int resetSize = 24;
constexpr int fieldHeight = 26;
constexpr int besideNames = 36;                       ///< px, edges and scroll bar of the open list
constexpr double markedWidth = 2.0;                   ///< px, of the frame around a marked row
constexpr double markedMargin = 6.0;                  ///< px, beside it
constexpr int overhang = ParameterSlider::handle / 2; ///< px, of the handle beyond the groove's ends

}

ParameterRow::ParameterRow(const OpenRun &run, RunEditor &editor, const lessons::Parameter &parameter,
                           const Theme &theme, QWidget *parent, Form form)
    : QWidget(parent), m_run(run), m_editor(editor), m_parameter(parameter), m_theme(theme), m_form(form)
{
    setFixedHeight(height);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    makeLabel();
    if (parameter.choices.isEmpty())
        makeFields();
    else
        makeChoice();
    m_unit = new QLabel(parameter.unit, this);
    m_unit->setObjectName("caption");
    m_unit->setFont(theme.ui(12));
    makeReset();
    auto *row = new QHBoxLayout(this);
    fill(*row);
    setToolTip(tr("%1 %2").arg(parameter.help, rangeText()));
    refresh();
}

void ParameterRow::makeLabel()
{
    m_label = new QWidget(this);
    m_name = new QLabel(m_parameter.name, m_label);
    m_name->setFont(m_theme.ui());
    m_symbol = new QLabel(m_parameter.symbol, m_label);
    m_symbol->setObjectName("symbol");
    m_symbol->setFont(m_theme.mono(12));
    QHBoxLayout *row = makeRow(m_label, 6);
    row->addWidget(m_name);
    row->addWidget(m_symbol);
    row->addStretch(1);
}

void ParameterRow::makeFields()
{
    m_slider = new ParameterSlider(m_parameter, m_theme, this);
    m_box = new NumberBox(m_parameter, m_theme, this);
    m_name->setBuddy(m_box);
    m_slider->setAccessibleName(tr("%1, slider").arg(m_parameter.name));
    m_box->setAccessibleName(m_parameter.unit.isEmpty() ? m_parameter.name
                                                        : m_parameter.name + ", " + m_parameter.unit);
    for (QWidget *field : {static_cast<QWidget *>(m_slider), static_cast<QWidget *>(m_box)})
        field->setAccessibleDescription(m_parameter.help);
    connect(m_slider, &ParameterSlider::chosen, this, &ParameterRow::choose);
    connect(m_slider, &ParameterSlider::sliderReleased, this, [this] { m_editor.endGesture(); });
    connect(m_box, &NumberBox::chosen, this, &ParameterRow::choose);
}

void ParameterRow::makeChoice()
{
    const QStringList &titles =
        m_parameter.choiceTitles.isEmpty() ? m_parameter.choices : m_parameter.choiceTitles;
    m_choice =
        lessons::groupOf(titles.front()).isEmpty() ? new QComboBox(this) : new GroupedChoice(titles, this);
    for (const QString &title : titles)
        m_choice->addItem(lessons::withoutGroup(title));
    for (int i = 0; i < m_parameter.choiceHelps.size(); ++i)
        m_choice->setItemData(i, m_parameter.choiceHelps[i], Qt::ToolTipRole);
    m_choice->setItemDelegate(
        new QStyledItemDelegate(m_choice)); // this delegate respects the row height of the style sheet
    m_choice->setMaxVisibleItems(14);
    m_choice->view()->setMinimumWidth(m_choice->view()->sizeHintForColumn(0) + besideNames);
    m_choice->setMinimumContentsLength(8); // long titles are cut instead of widening the panel
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_choice->setAccessibleName(m_parameter.name);
    m_choice->setAccessibleDescription(m_parameter.help);
    m_choice->setFocusPolicy(Qt::TabFocus);
    m_choice->setFixedHeight(fieldHeight);
    m_name->setBuddy(m_choice);
    connect(m_choice, &QComboBox::currentIndexChanged, this, [this](int index) { choose(index); });
}

void ParameterRow::makeReset()
{
    m_reset = new QToolButton(this);
    m_reset->setObjectName("reset");
    showIcon(*m_reset, "reset", m_theme, &Tokens::ink3);
    m_reset->setFixedSize(resetSize, resetSize);
    m_reset->setIconSize({14, 14});
    m_reset->setFocusPolicy(Qt::TabFocus);
    const QString preset = m_choice ? m_choice->itemText(static_cast<int>(m_parameter.defaultValue))
                                    : writtenNumber(m_parameter.defaultValue, m_parameter.decimals);
    m_reset->setToolTip(tr("Reset to %1").arg(preset));
    m_reset->setAccessibleName(tr("Reset %1 to %2").arg(m_parameter.name, preset));
    QSizePolicy policy = m_reset->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    m_reset->setSizePolicy(policy);
    connect(m_reset, &QToolButton::clicked, this, [this] { choose(m_parameter.defaultValue); });
}

void ParameterRow::fill(QHBoxLayout &row)
{
    row.setContentsMargins(leftMargin, 0, rightMargin, 0);
    row.setSpacing(0);
    row.addWidget(m_label);
    if (m_choice) {
        row.addWidget(m_choice, 1);
    } else {
        row.addWidget(m_slider, 1);
        row.addSpacing(12 - overhang);
        row.addWidget(m_box);
    }
    if (m_form == Form::brief) {
        row.setContentsMargins(besideBrief, 0, besideBrief, 0);
        m_unit->hide();
        return;
    }
    row.addSpacing(unitGap);
    row.addWidget(m_unit);
    row.addWidget(m_reset);
}

int ParameterRow::wantedLabelWidth() const
{
    return m_label->sizeHint().width() + 8;
}

int ParameterRow::wantedUnitWidth() const
{
    return m_unit->sizeHint().width();
}

void ParameterRow::setColumns(int label, int unit)
{
    m_label->setFixedWidth(m_choice ? label : label - overhang);
    // A choice without a unit uses the unit column for its long names.
    m_unit->setFixedWidth(m_choice && m_parameter.unit.isEmpty() ? 0 : unit);
}

void ParameterRow::setMarked(bool isMarked)
{
    if (isMarked == m_isMarked)
        return;
    m_isMarked = isMarked;
    update();
}

void ParameterRow::paintEvent(QPaintEvent *)
{
    if (!m_isMarked)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_theme.tokens().ink, markedWidth));
    painter.drawRoundedRect(QRectF(rect()).adjusted(markedMargin, 2.0, -markedMargin, -2.0), 6.0, 6.0);
}

QString ParameterRow::rangeText() const
{
    if (m_choice)
        return {};
    const QString unit = m_parameter.unit.isEmpty() ? QString() : QChar(0x2009) + m_parameter.unit;
    return tr("It can be %1 to %2%3.")
        .arg(writtenNumber(m_parameter.min, 0), writtenNumber(m_parameter.max, 0), unit);
}

void ParameterRow::choose(double value)
{
    m_editor.setParameter(m_parameter.id, value);
    if (!m_slider || !m_slider->isSliderDown())
        m_editor.endGesture();
    if (value < m_parameter.min || value > m_parameter.max) { // after the change, which clears the status bar
        m_run.showMessage(
            tr("%1 can be %2 to %3.")
                .arg(m_parameter.name, writtenNumber(m_parameter.min, 0), writtenNumber(m_parameter.max, 0)));
    }
    refresh(); // also if nothing changed, because the typed value may have been clamped
}

bool ParameterRow::isChanged() const
{
    return m_editor.parameter(m_parameter.id) != m_parameter.defaultValue;
}

void ParameterRow::refresh()
{
    const double value = m_editor.parameter(m_parameter.id);
    if (m_choice) {
        const QSignalBlocker silent(m_choice);
        m_choice->setCurrentIndex(static_cast<int>(value));
    } else {
        m_slider->show(value);
        m_box->show(value);
        m_box->setToolTip(m_box->exactText(value) + QChar(0x2009) + m_parameter.unit + '\n' + toolTip());
        const sim::Track *comparison = m_run.timeline().comparison();
        const std::string id = m_parameter.id.toStdString();
        std::optional<double> was;
        if (comparison && comparison->nextInterval()->values.has(id) &&
            comparison->nextInterval()->values[id] != value)
            was = comparison->nextInterval()->values[id];
        m_slider->setComparison(was);
    }
    m_reset->setVisible(m_form == Form::whole && value != m_parameter.defaultValue);
}

}
