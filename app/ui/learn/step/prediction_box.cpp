#include "app/ui/learn/step/prediction_box.h"

#include "app/model/learning/prediction_text.h"
#include "app/ui/learn/button_flow.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/prose.h"
#include "app/ui/learn/step/curve_button.h"
#include "app/ui/learn/why_box.h"

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

constexpr int predictionLeft = 19; ///< px: aligned with the question, which has an arrow before it
constexpr int numberWidth = 84;    ///< px

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
    : QWidget(parent), m_desk(desk), m_prediction(prediction),
      m_title(new WhyButton(plainText(prediction.text), theme, this)), m_content(new QWidget(this))
{
    setObjectName("prediction");
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    m_content->setSizePolicy(policy);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_content);
    auto *parts = new QVBoxLayout(m_content);
    parts->setContentsMargins(predictionLeft, 2, 0, 6);
    parts->setSpacing(4);
    m_sentence = new NarrationText(theme, m_content, NarrationText::Kind::aside);
    m_sentence->setObjectName("predictionSentence");
    m_answer = new NarrationText(theme, m_content, NarrationText::Kind::aside);
    m_answer->setObjectName("predictionAnswer");
    m_answer->setText(prediction.answer);
    if (prediction.question.kind == AskedFor::number)
        addNumberField(*parts);
    else if (prediction.question.kind == AskedFor::curve) {
        for (int i = 0; i < 3; ++i)
            m_curves[static_cast<std::size_t>(i)] = new CurveButton(i + 1, theme, m_content);
        addCurveField(*parts);
    }
    parts->addWidget(m_sentence);
    parts->addWidget(m_answer);
    addButtons(*parts);
    const auto describe = [this](bool isOpen) {
        m_title->setToolTip(isOpen ? tr("Fold this prediction") : tr("Predict what happens"));
    };
    connect(m_title, &QAbstractButton::toggled, this, [this, describe](bool isOpen) {
        m_content->setVisible(isOpen);
        describe(isOpen);
        emit unfolded(isOpen);
    });
    describe(false);
    m_content->hide();
    refresh();
}

void PredictionBox::addNumberField(QVBoxLayout &column)
{
    const lessons::Question &question = m_prediction.question;
    const QString unit = question.asksFrames() ? tr("frames") : question.unit;
    m_numberRow = new QWidget(m_content);
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
    column.addWidget(m_numberRow);
    connect(m_number, &QLineEdit::textEdited, this, &PredictionBox::sayNumber);
    connect(m_number, &QLineEdit::returnPressed, this, [this] { m_desk.commit(m_prediction.id); });
}

void PredictionBox::sayNumber(const QString &text)
{
    const std::optional<double> number = typedNumber(text);
    m_desk.say(m_prediction.id, number ? std::optional(PredictedAnswer{.number = *number}) : std::nullopt);
}

void PredictionBox::addCurveField(QVBoxLayout &column)
{
    m_curveRow = new QWidget(m_content);
    auto *row = new QHBoxLayout(m_curveRow);
    row->setContentsMargins(0, 2, 0, 2);
    row->setSpacing(6);
    const std::array<int, 3> order = curveOrder(m_prediction);
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        m_curves[i]->setParent(m_curveRow);
        row->addWidget(m_curves[i]);
        connect(m_curves[i], &QAbstractButton::clicked, this,
                [this, curve = order[i]] { m_desk.say(m_prediction.id, PredictedAnswer{.curve = curve}); });
    }
    column.addWidget(m_curveRow);
}

QPushButton *PredictionBox::addButton(const QString &name, const QString &text, const QString &tip)
{
    auto *button = new QPushButton(m_buttons->strip());
    m_buttons->add(button);
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAutoDefault(false);
    return button;
}

void PredictionBox::addButtons(QVBoxLayout &column)
{
    m_buttons = new ButtonFlow(m_content);
    m_commit = addButton("commitPrediction", tr("Play it"), {});
    m_commit->setProperty("primary", true);
    if (m_prediction.question.kind == AskedFor::place) {
        m_pick = addButton(
            "pickPlace", tr("Choose the place"),
            tr("Shows how the run begins. Then click a place, or move the cross with the arrow keys."));
        connect(m_pick, &QPushButton::clicked, this, [this] { m_desk.pick(m_prediction.id); });
    }
    m_again = addButton("predictAgain", tr("Predict again"),
                        tr("Forgets this answer, so that you can give another one"));
    column.addWidget(m_buttons);
    connect(m_commit, &QPushButton::clicked, this, [this] { m_desk.commit(m_prediction.id); });
    connect(m_again, &QPushButton::clicked, this, [this] { m_desk.startAgain(m_prediction.id); });
}

void PredictionBox::open()
{
    m_title->setChecked(true);
}

bool PredictionBox::isActive() const
{
    return m_stage == PredictionStage::playing && !m_content->isHidden();
}

bool PredictionBox::isPicking() const
{
    return m_desk.picking() && m_desk.picking()->id == m_prediction.id;
}

void PredictionBox::focusField()
{
    open();
    QWidget *field = m_pick ? static_cast<QWidget *>(m_pick) : m_number;
    if (!field)
        field = m_curves[0];
    field->setFocus(Qt::ShortcutFocusReason);
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
    const QString question = plainText(m_prediction.text);
    m_title->setText(isShown ? question + QStringLiteral(" ✓") : question);
    m_title->setAccessibleName(isShown ? tr("%1, predicted").arg(question) : question);
    m_title->updateGeometry();
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
    return !m_content->isHidden();
}

void PredictionBox::keyPressEvent(QKeyEvent *event)
{
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const int number = event->key() - Qt::Key_1;
    if (m_content->isHidden() || m_stage != PredictionStage::open) {
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
