#pragma once

#include "app/model/learning/prediction_desk.h"
#include "app/ui/learn/fold_box.h"

#include <array>

class QLineEdit;
class QPushButton;

namespace app {

class ButtonFlow;
class CurveButton;
class NarrationText;

/// A prediction, folded to its question. Unfolded, it has a field for the answer and a button that plays the run. After
/// the run it shows what the learner said, what came out, and why.
class PredictionBox : public FoldBox
{
    Q_OBJECT

public:
    /// `desk` and `theme` must outlive this object. `prediction` must be one of the open step.
    PredictionBox(PredictionDesk &desk, const lessons::Prediction &prediction, const Theme &theme,
                  QWidget *parent = nullptr);

    QString id() const { return m_prediction.id; }
    /// Shows the present state of the desk. Returns whether the height can be another.
    bool refresh();
    /// Returns whether its run plays.
    bool isActive() const;
    /// Returns whether the learner chooses its place in the scene now.
    bool isPicking() const;
    /// Unfolds the box, and moves the keyboard focus to the field for the answer.
    void focusField();

protected:
    void fill() override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void describe();
    void addNumberField();
    void addCurveField();
    void addButtons();
    void sayNumber(const QString &text);
    /// Moves the keyboard focus to the field for a number, if it is open.
    void focusNumber();
    void showField(const PredictionDesk::Sheet &sheet);
    void showCurves(const PredictionDesk::Sheet &sheet);
    QString sentence(const PredictionDesk::Sheet &sheet) const;

    PredictionDesk &m_desk;
    const lessons::Prediction m_prediction; ///< a copy: the documents of a step can be read again
    QPushButton *m_pick = nullptr;          ///< of a place
    QWidget *m_numberRow = nullptr;         ///< of a number
    QLineEdit *m_number = nullptr;
    QWidget *m_curveRow = nullptr; ///< of curves
    std::array<CurveButton *, 3> m_curves = {};
    ButtonFlow *m_buttons = nullptr;
    QPushButton *m_commit = nullptr;
    QPushButton *m_again = nullptr;
    NarrationText *m_sentence = nullptr;
    NarrationText *m_answer = nullptr;
    bool m_hasCurves = false;                                    ///< whether the curves are shown
    PredictionDesk::Stage m_stage = PredictionDesk::Stage::open; ///< as last shown
};

}
