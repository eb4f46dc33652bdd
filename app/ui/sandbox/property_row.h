#pragma once

#include "app/model/sandbox/sandbox_editor.h"
#include "app/model/sandbox/sandbox_properties.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

class QCheckBox;
class QLabel;

namespace app {

class NumberBox;

/// A row of the sandbox panel: one property of the selected parts, with a field or a switch.
class PropertyRow : public QWidget
{
    Q_OBJECT

public:
    PropertyRow(SandboxEditor &editor, SandboxProperty property, const Theme &theme,
                QWidget *parent = nullptr);

    const SandboxProperty &property() const { return m_property; }
    /// Sets the title of the property's section.
    void setSection(const QString &section);
    /// Shows the value of the present selection.
    void refresh();

    static constexpr int height = 32;
    static constexpr int margin = 16;     ///< px, left and right
    static constexpr int labelWidth = 88; ///< px, at least

private:
    void makeBox(const Theme &theme);
    void makeSwitch();
    void choose(double value);

    SandboxEditor &m_editor;
    SandboxProperty m_property;
    QLabel *m_name;
    QLabel *m_unit;
    NumberBox *m_box = nullptr;
    QCheckBox *m_switch = nullptr;
};

}
