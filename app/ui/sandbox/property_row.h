#pragma once

#include "app/model/built_properties.h"
#include "app/model/workbench.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

class QCheckBox;
class QLabel;

namespace app {

class NumberBox;

/// A line of the build panel: one property of what is chosen, with a field or a switch.
class PropertyRow : public QWidget
{
    Q_OBJECT

public:
    PropertyRow(Workbench &bench, BuiltProperty property, const Theme &theme, QWidget *parent = nullptr);

    const BuiltProperty &property() const { return m_property; }
    /// Shows what is chosen now.
    void refresh();

    static constexpr int height = 32;

private:
    void makeBox(const Theme &theme);
    void makeSwitch();
    void choose(double value);

    Workbench &m_bench;
    BuiltProperty m_property;
    QLabel *m_name;
    QLabel *m_unit;
    NumberBox *m_box = nullptr;
    QCheckBox *m_switch = nullptr;
};

}
