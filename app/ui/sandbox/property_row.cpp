#include "app/ui/sandbox/property_row.h"

#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"
#include "app/ui/parameters/number_box.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace app {

PropertyRow::PropertyRow(SandboxEditor &editor, SandboxProperty property, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_editor(editor), m_property(std::move(property)),
      m_name(new QLabel(m_property.about.name, this)), m_unit(new QLabel(this))
{
    setFixedHeight(height);
    const lessons::Parameter &about = m_property.about;
    m_unit->setObjectName("caption");
    m_name->setMinimumWidth(labelWidth);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(margin, 0, margin, 0);
    row->setSpacing(8);
    row->addWidget(m_name);
    if (m_property.isTruth) {
        makeSwitch();
        row->addWidget(m_switch);
    } else {
        makeBox(theme);
        row->addWidget(m_box);
    }
    setSection(m_property.section);
    row->addWidget(m_unit);
    row->addStretch(1);
    setToolTip(m_property.isTruth
                   ? about.help
                   : tr("%1 From %2 to %3.").arg(about.help, exactNumber(about.min), exactNumber(about.max)));
    refresh();
}

void PropertyRow::makeBox(const Theme &theme)
{
    m_box = new NumberBox(m_property.about, theme, this);
    m_box->setRounding(true); // dragging leaves lengths and places such as 108.16653826391968
    m_name->setBuddy(m_box);
    m_box->setAccessibleDescription(m_property.about.help);
    connect(m_box, &NumberBox::chosen, this, &PropertyRow::choose);
}

void PropertyRow::makeSwitch()
{
    m_switch = new QCheckBox(this);
    m_name->setBuddy(m_switch);
    m_switch->setAccessibleDescription(m_property.about.help);
    m_switch->setFocusPolicy(Qt::TabFocus);
    connect(m_switch, &QCheckBox::clicked, this, [this](bool on) { choose(on ? 1.0 : 0.0); });
}

void PropertyRow::setSection(const QString &section)
{
    m_property.section = section;
    const lessons::Parameter &about = m_property.about;
    const QString name = about.unit.isEmpty() ? about.name : about.name + ", " + about.unit;
    if (m_box)
        m_box->setAccessibleName(section + ": " + name);
    if (m_switch)
        m_switch->setAccessibleName(section + ": " + about.name);
}

void PropertyRow::choose(double value)
{
    const lessons::Parameter &about = m_property.about;
    value = std::clamp(value, about.min, about.max);
    if (about.isInteger)
        value = std::round(value);
    const Selection chosen = m_editor.chosen();
    const QString what =
        !m_property.isTruth
            ? tr("Change %1 of %2").arg(withinSentence(about.name), withinSentence(m_property.section))
        : value != 0.0 ? tr("Switch “%1” on").arg(about.name)
                       : tr("Switch “%1” off").arg(about.name);
    m_editor.change(what, [&](sim::Blueprint &plan) { m_property.set(plan, chosen, value); });
    refresh(); // replaces a value that was rejected or out of range
}

void PropertyRow::refresh()
{
    if (!m_editor.isOpen())
        return;
    const std::optional<double> value = m_property.get(m_editor.plan(), m_editor.chosen());
    m_unit->setText(value ? m_property.about.unit : tr("different"));
    if (m_box)
        value ? m_box->show(*value) : m_box->showNothing();
    if (m_box && value)
        m_box->setToolTip(m_box->exactText(*value) + ' ' + m_property.about.unit + '\n' + toolTip());
    if (!m_switch)
        return;
    const QSignalBlocker silent(m_switch);
    m_switch->setTristate(!value);
    m_switch->setCheckState(!value ? Qt::PartiallyChecked : *value != 0.0 ? Qt::Checked : Qt::Unchecked);
}

}
