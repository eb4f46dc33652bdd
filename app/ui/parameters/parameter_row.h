#pragma once

#include "app/model/session/open_run.h"
#include "app/model/session/run_editor.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace app {

class NumberBox;
class ParameterSlider;

/// A row with one parameter: name, slider, number, unit, and a button that resets it to its preset.
class ParameterRow : public QWidget
{
    Q_OBJECT

public:
    static constexpr int height = 36;

    /// How much of the row is shown.
    enum class Form {
        whole,
        brief, ///< for a bar: without unit and reset; the field's tooltip and name still state the unit
    };

    ParameterRow(const OpenRun &run, RunEditor &editor, const lessons::Parameter &parameter,
                 const Theme &theme, QWidget *parent = nullptr, Form form = Form::whole);

    const lessons::Parameter &parameter() const { return m_parameter; }
    /// Shows the values at the cursor, of the run and of its comparison run.
    void refresh();
    bool isChanged() const;

    int wantedLabelWidth() const;
    int wantedUnitWidth() const;
    /// Sets the column widths that all rows of a panel share, px.
    void setColumns(int label, int unit);
    /// Sets whether a frame marks the row, because a formula is about its parameter.
    void setMarked(bool isMarked);
    bool isMarked() const { return m_isMarked; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void makeLabel();
    void makeFields();
    void makeChoice();
    void makeReset();
    void fill(QHBoxLayout &row);
    void choose(double value);
    QString rangeText() const;

    const OpenRun &m_run;
    RunEditor &m_editor;
    lessons::Parameter m_parameter;
    const Theme &m_theme;
    Form m_form;
    bool m_isMarked = false;
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
