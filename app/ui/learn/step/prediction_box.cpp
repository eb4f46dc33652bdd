#include "app/ui/learn/step/prediction_box.h"

#include "app/model/learning/prediction_text.h"
#include "app/ui/dock/button_flow.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/prose.h"
#include "app/ui/learn/step/curve_button.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QRegularExpressionValidator>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

namespace {

using AskedFor = lessons::Question::Kind;
using PredictionStage = PredictionDesk::Stage;

constexpr int numberWidth = 84; ///< px

/// Returns the number in `text`, with a point or a comma; empty if it is none.
std::optional<double> typedNumber(const QString &text)
{
    bool isNumber = false;
    const double value = QString(text).replace(',', '.').replace(QChar(0x2212), '-').toDouble(&isNumber);
    return isNumber ? std::optional(value) : std::nullopt;
}

}

PredictionBox::PredictionBox(PredictionDesk &desk, const lessons::Prediction &prediction, const Theme &theme,
                             QWidget *parent)
    : FoldBox(prediction.text, theme, parent), m_desk(desk), m_prediction(prediction)
{
    setObjectName("prediction");
    column().setSpacing(4);
    connect(this, &FoldBox::unfolded, this, &PredictionBox::describe);
    connect(&title(), &QAbstractButton::clicked, this, &PredictionBox::focusNumber);
    refresh();
}

void PredictionBox::fill()
{
    m_sentence = addText("predictionSentence", {});
    m_answer = addText("predictionAnswer", m_prediction.answer);
    if (m_prediction.question.kind == AskedFor::number)
        addNumberField();
    else if (m_prediction.question.kind == AskedFor::curve)
        addCurveField();
    addButtons();
    connect(m_again, &QAbstractButton::clicked, this, &PredictionBox::focusNumber);
    refresh();
}

void PredictionBox::describe()
{
    const bool isAnswered = m_stage == PredictionStage::shown;
    if (isUnfolded())
        title().setToolTip(isAnswered ? tr("Answered. Fold this prediction") : tr("Fold this prediction"));
    else
        title().setToolTip(isAnswered ? tr("Answered. Show it again") : tr("Predict what happens"));
}

void PredictionBox::addNumberField()
{
    const lessons::Question &question = m_prediction.question;
    const QString unit = question.asksFrames() ? tr("frames") : question.unit;
    m_numberRow = new QWidget(content());
    m_number = new QLineEdit(m_numberRow);
    m_number->setObjectName("predictedNumber");
    m_number->setFixedWidth(numberWidth);
    m_number->setMaxLength(12);
    m_number->setPlaceholderText(tr("a number"));
    static const QRegularExpression pattern(QStringLiteral("[-+\u2212]?\\d*([.,]\\d*)?"));
    m_number->setValidator(new QRegularExpressionValidator(pattern, m_number));
    m_number->setToolTip(tr("Type your prediction. Enter plays the run."));
    m_number->setAccessibleName(unit.isEmpty() ? tr("Your prediction") : tr("Your prediction, %1").arg(unit));
    m_number->setAccessibleDescription(plainText(m_prediction.text));
    auto *unitLabel = new QLabel(unit, m_numberRow);
    unitLabel->setObjectName("caption");
    auto *row = new QHBoxLayout(m_numberRow);
    row->setContentsMargins(0, 2, 0, 2);
    row->setSpacing(8);
    row->addWidget(m_number);
    row->addWidget(unitLabel);
    row->addStretch(1);
    column().insertWidget(0, m_numberRow);
    connect(m_number, &QLineEdit::textEdited, this, &PredictionBox::sayNumber);
    connect(m_number, &QLineEdit::returnPressed, this, [this] { m_desk.commit(m_prediction.id); });
}

void PredictionBox::sayNumber(const QString &text)
{
    const std::optional<double> number = typedNumber(text);
    m_desk.say(m_prediction.id, number ? std::optional(PredictedAnswer{.number = *number}) : std::nullopt);
}

void PredictionBox::addCurveField()
{
    m_curveRow = new QWidget(content());
    auto *row = new QHBoxLayout(m_curveRow);
    row->setContentsMargins(0, 2, 0, 2);
    row->setSpacing(6);
    const std::array<int, 3> order = curveOrder(m_prediction);
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        m_curves[i] = new CurveButton(static_cast<int>(i) + 1, theme(), m_curveRow);
        row->addWidget(m_curves[i]);
        connect(m_curves[i], &QAbstractButton::clicked, this,
                [this, curve = order[i]] { m_desk.say(m_prediction.id, PredictedAnswer{.curve = curve}); });
    }
    column().insertWidget(0, m_curveRow);
}

void PredictionBox::addButtons()
{
    m_buttons = new ButtonFlow(content());
    m_commit = m_buttons->add<QPushButton>("commitPrediction", tr("Play it"), {});
    m_commit->setProperty("primary", true);
    if (m_prediction.question.kind == AskedFor::place) {
        m_pick = m_buttons->add<QPushButton>(
            "pickPlace", tr("Choose the place"),
            tr("Shows how the run begins. Then click a place, or move the cross with the arrow keys."));
        connect(m_pick, &QPushButton::clicked, this, [this] { m_desk.pick(m_prediction.id); });
    }
    m_again = m_buttons->add<QPushButton>("predictAgain", tr("Predict again"),
                                          tr("Forgets this answer, so that you can give another one"));
    column().addWidget(m_buttons);
    connect(m_commit, &QPushButton::clicked, this, [this] { m_desk.commit(m_prediction.id); });
    connect(m_again, &QPushButton::clicked, this, [this] { m_desk.startAgain(m_prediction.id); });
}

bool PredictionBox::isActive() const
{
    return m_stage == PredictionStage::playing && isUnfolded();
}

bool PredictionBox::isPicking() const
{
    return m_desk.picking() && m_desk.picking()->id == m_prediction.id;
}

void PredictionBox::focusField()
{
    setUnfolded(true);
    QWidget *field = m_pick ? static_cast<QWidget *>(m_pick) : m_number;
    if (!field)
        field = m_curves[0];
    field->setFocus(Qt::ShortcutFocusReason);
}

void PredictionBox::focusNumber()
{
    // Digits are keys of the scene, too: 0 zooms to 100 %.
    if (m_number && isUnfolded() && m_stage == PredictionStage::open)
        m_number->setFocus(Qt::ShortcutFocusReason);
}

QString PredictionBox::sentence(const PredictionDesk::Sheet &sheet) const
{
    if (!sheet.mistake.isEmpty())
        return sheet.mistake;
    switch (sheet.stage) {
    case PredictionStage::shown:
        return sheet.said && sheet.found ? outcomeSentence(m_prediction, *sheet.said, *sheet.found)
                                         : QString();
    case PredictionStage::playing:
        return m_desk.truth(m_prediction.id) ? tr("Watch the run. It stops by itself.") : tr("One moment …");
    case PredictionStage::open:
        break;
    }
    if (sheet.wasInterrupted)
        return tr("The run was changed on the way. Play it again to see how it ends.");
    if (m_prediction.question.kind == AskedFor::place && sheet.said)
        return tr("Your cross is at **%1**.").arg(answerWords(m_prediction, *sheet.said));
    return isPicking() ? tr("Click in the scene, or move the cross with the arrow keys.") : QString();
}

void PredictionBox::showCurves(const PredictionDesk::Sheet &sheet)
{
    const std::array<int, 3> order = curveOrder(m_prediction);
    const PredictionTruth *truth = m_desk.truth(m_prediction.id);
    m_curveRow->setEnabled(sheet.stage == PredictionStage::open && truth);
    double least = std::numeric_limits<double>::infinity(), most = -least;
    if (truth && truth->curves.size() == m_curves.size()) {
        for (const std::vector<double> &curve : truth->curves) {
            for (const double value : curve) {
                least = std::isfinite(value) ? std::min(least, value) : least;
                most = std::isfinite(value) ? std::max(most, value) : most;
            }
        }
    }
    const QString &of = m_prediction.question.of;
    const bool pointsDown = of.endsWith(u".y") || of.endsWith(u".vy");
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        const int curve = order[i];
        m_curves[i]->setChecked(sheet.said && sheet.said->curve == curve);
        m_curves[i]->setRight(sheet.stage == PredictionStage::shown && curve == 0);
        if (!m_hasCurves && truth && truth->curves.size() == m_curves.size())
            m_curves[i]->setCurve(truth->curves[static_cast<std::size_t>(curve)], least, most, pointsDown);
    }
    m_hasCurves = truth != nullptr;
}

void PredictionBox::showField(const PredictionDesk::Sheet &sheet)
{
    const bool isOpen = sheet.stage == PredictionStage::open;
    if (m_pick) {
        m_pick->setVisible(isOpen && !isPicking());
        m_pick->setText(sheet.said ? tr("Move the cross") : tr("Choose the place"));
    }
    if (m_numberRow) {
        m_numberRow->setVisible(isOpen);
        if (sheet.said && typedNumber(m_number->text()) != sheet.said->number)
            m_number->setText(QLocale().toString(sheet.said->number, 'g', 10));
        else if (!sheet.said && typedNumber(m_number->text()))
            m_number->clear();
    }
    if (m_curveRow)
        showCurves(sheet);
}

bool PredictionBox::refresh()
{
    const PredictionDesk::Sheet sheet = m_desk.sheet(m_prediction.id);
    m_stage = sheet.stage;
    const bool isOpen = sheet.stage == PredictionStage::open, isShown = sheet.stage == PredictionStage::shown;
    showTitle(m_prediction.text, isShown, tr("%1, answered").arg(plainText(m_prediction.text)));
    describe();
    if (!isFilled())
        return false;
    showField(sheet);
    const QString text = sentence(sheet);
    m_sentence->setText(text);
    m_sentence->setVisible(!text.isEmpty());
    m_answer->setVisible(isShown);
    m_commit->setVisible(isOpen && (!m_pick || sheet.said || isPicking()));
    m_commit->setEnabled(sheet.said && sheet.mistake.isEmpty());
    m_commit->setToolTip(m_commit->isEnabled()
                             ? tr("Plays the run, and compares it with your prediction. Undo brings your "
                                  "own run back.")
                             : tr("Predict first."));
    m_again->setVisible(!isOpen);
    m_buttons->refresh();
    return isUnfolded();
}

void PredictionBox::keyPressEvent(QKeyEvent *event)
{
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const int number = event->key() - Qt::Key_1;
    if (!isUnfolded() || m_stage != PredictionStage::open) {
        QWidget::keyPressEvent(event);
    } else if (isEnter && m_pick && m_pick->hasFocus()) {
        m_pick->click();
    } else if (isEnter) {
        m_desk.commit(m_prediction.id);
    } else if (m_curveRow && m_curveRow->isEnabled() && number >= 0 && number < 3) {
        m_curves[static_cast<std::size_t>(number)]->setFocus(Qt::ShortcutFocusReason);
        m_curves[static_cast<std::size_t>(number)]->click();
    } else {
        QWidget::keyPressEvent(event);
    }
}

}
