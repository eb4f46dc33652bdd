#pragma once

#include "app/model/learning/prediction_desk.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

#include <array>

class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace app {

class ButtonFlow;
class CurveButton;
class NarrationText;
class WhyButton;

/// A prediction, folded to its question. Unfolded, it has a field for the answer and a button that plays the run. After
/// the run it shows what the learner said, what came out, and why.
class PredictionBox : public QWidget
{
    Q_OBJECT

public:
    /// `desk` and `theme` must outlive this object. `prediction` must be one of the open step.
    PredictionBox(PredictionDesk &desk, const lessons::Prediction &prediction, const Theme &theme,
                  QWidget *parent = nullptr);

    QString id() const { return m_prediction.id; }
    /// Unfolds the box.
    void open();
    /// Shows the present state of the desk. Returns whether the height can be another.
    bool refresh();
    /// Returns whether its run plays.
    bool isActive() const;
    /// Returns whether the learner chooses its place in the scene now.
    bool isPicking() const;
    /// Unfolds the box, and moves the keyboard focus to the field for the answer.
    void focusField();

signals:
    /// Emitted when the box is folded or unfolded.
    void unfolded(bool open);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void addNumberField(QVBoxLayout &column);
    void addCurveField(QVBoxLayout &column);
    void addButtons(QVBoxLayout &column);
    QPushButton *addButton(const QString &name, const QString &text, const QString &tip);
    void sayNumber(const QString &text);
    void showField(const PredictionDesk::Sheet &sheet);
    void showCurves(const PredictionDesk::Sheet &sheet);
    QString sentence(const PredictionDesk::Sheet &sheet) const;

    PredictionDesk &m_desk;
    const lessons::Prediction m_prediction; ///< a copy: the documents of a step can be read again
    WhyButton *m_title;
    QWidget *m_content;
    QPushButton *m_pick = nullptr;  ///< of a place
    QWidget *m_numberRow = nullptr; ///< of a number
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
