#pragma once

#include "app/model/session.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace app {

class NumberBox;
class ParameterSlider;

/// One parameter: name, slider, number, unit, and a way back to its preset.
class ParameterRow : public QWidget
{
    Q_OBJECT

public:
    static constexpr int height = 36;

    /// How much there is of it.
    enum class Form {
        whole,
        brief, ///< for a bar: without unit and reset, which its field's tooltip and name still tell
    };

    ParameterRow(Session &session, const lessons::Parameter &parameter, const Theme &theme,
                 QWidget *parent = nullptr, Form form = Form::whole);

    const lessons::Parameter &parameter() const { return m_parameter; }
    /// Shows the values at the cursor, of the run and of its ghost.
    void refresh();
    bool isChanged() const;

    int wantedLabelWidth() const;
    int wantedUnitWidth() const;
    /// Rows of one panel share these.
    void setColumns(int label, int unit);

private:
    void makeLabel();
    void makeFields();
    void makeChoice();
    void makeReset();
    void fill(QHBoxLayout &row);
    void choose(double value);
    void dress();
    QString rangeText() const;

    Session &m_session;
    lessons::Parameter m_parameter;
    const Theme &m_theme;
    Form m_form;
    QWidget *m_label = nullptr;
    QLabel *m_name = nullptr;
    QLabel *m_symbol = nullptr;
    ParameterSlider *m_slider = nullptr; ///< null for a choice
    NumberBox *m_box = nullptr;          ///< null for a choice
    QComboBox *m_choice = nullptr;       ///< null for a number
    QLabel *m_unit = nullptr;
    QToolButton *m_reset = nullptr;
};

}
