#include "app/ui/learn/step/narration.h"

#include "app/model/text/glossary.h"
#include "app/ui/actions/command.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/prose.h"
#include "app/ui/learn/step/part_link.h"
#include "app/ui/learn/step/prediction_box.h"
#include "app/ui/learn/step/task_box.h"
#include "app/ui/learn/step/try_box.h"
#include "app/ui/learn/step_buttons.h"
#include "app/ui/learn/why_box.h"
#include "app/ui/theme/icon_button.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>

namespace app {

namespace {

constexpr int largeWindow = 1600; ///< px, the window width from which the type is larger
constexpr int titleHeight = 24;
constexpr int headingHeight = 20;
constexpr int belowText = 12;   ///< px above the tasks
constexpr int belowWhys = 6;    ///< px: a question has some px below it already
constexpr int leastAbove = 200; ///< px of text above the things to try; with less, these scroll
constexpr int leastTask = 240;  ///< the same while the learner writes a task
constexpr int todoMilliseconds =
    300; ///< between two updates of the missing tasks: faster changes cannot be read

QLabel *makeHeading(const QString &text, QWidget *parent)
{
    auto *heading = new QLabel(text, parent);
    heading->setObjectName("heading");
    heading->setFixedHeight(headingHeight);
    return heading;
}

}

Narration::Narration(Session &session, const Glossary &glossary, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_theme(theme), m_room(*this), m_predictions(session),
      m_desk(session)
{
    styleAsPanel(*this);
    makeText();
    m_text->setGlossary(glossary);
    makeTries();
    makeButtons();
    m_room.addBelow(m_tryHead, m_tryPage, m_buttons);
    m_tryPage->installEventFilter(this);
    session.onChange(ChangeKind::step, this, &Narration::open);
    session.onChange(ChangeKind::texts, this, [this] {
        const int scrolled = m_room.bar().value();
        open();
        m_room.bar().setValue(scrolled);
    });
    connect(&session.progress(), &Progress::changed, this, &Narration::showProgress);
    connect(&m_predictions, &PredictionDesk::changed, this, &Narration::showPredictions);
    connect(&m_desk, &TaskDesk::changed, this, &Narration::showTasks);
    connect(&session.progress(), &Progress::changed, this, &Narration::showTasks);
    m_todoDue.setSingleShot(true);
    m_todoDue.setInterval(todoMilliseconds);
    connect(&m_todoDue, &QTimer::timeout, this, &Narration::showTodos);
    session.onChange(ChangeKind::run | ChangeKind::cursor | ChangeKind::playing, this, [this] {
        if (!m_todoDue.isActive())
            m_todoDue.start();
    });
    open();
}

void Narration::makeText()
{
    QWidget *page = m_room.page();
    m_title = makeTextLabel("stepTitle", {}, page);
    m_title->setTextFormat(Qt::PlainText);
    m_title->setMinimumHeight(titleHeight);
    m_text = new NarrationText(m_theme, page);
    auto *column = new QVBoxLayout;
    column->setContentsMargins(18, 12, 18, 8);
    column->setSpacing(0);
    m_room.addText(column);
    column->addWidget(m_title);
    column->addSpacing(5);
    column->addWidget(m_text);
    m_predictionHeading = makeHeading(tr("Predict, then play"), page);
    m_predictionColumn = new QVBoxLayout;
    m_predictionColumn->setSpacing(0);
    m_predictionColumn->addWidget(m_predictionHeading);
    column->addLayout(m_predictionColumn);
    m_whyColumn = new QVBoxLayout;
    m_whyColumn->setSpacing(0);
    column->addLayout(m_whyColumn);
    m_taskHeading = makeHeading(tr("Write it yourself"), page);
    m_taskColumn = new QVBoxLayout;
    m_taskColumn->setSpacing(0);
    m_taskColumn->addWidget(m_taskHeading);
    column->addLayout(m_taskColumn);
    connect(m_text, &NarrationText::linkActivated, this, [this](const QUrl &link, const QPoint &place) {
        if (!wordOf(link).isEmpty())
            emit wordRequested(wordOf(link), place);
    });
}

void Narration::makeTries()
{
    m_tryHead = new QWidget(this);
    m_tryPage = new QWidget(this);
    // The width decides about the height; the height at the least width would leave gaps.
    m_tryPage->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);
    m_heading = makeHeading(tr("Try this"), m_tryHead);
    m_heading->setIndent(TryBox::left);
    m_tryColumn = new QVBoxLayout(m_tryPage);
    m_tryColumn->setContentsMargins(18 - TryBox::left, 0, 18, 4);
    m_tryColumn->setSpacing(0);
    m_toPredictions = new PartLink(tr("Predict first"),
                                   tr("Goes to a question about a run, at the end of the text"), m_tryHead);
    m_toPredictions->setObjectName("toPredictions");
    m_toTask = new PartLink(tr("Write it yourself"),
                            tr("Goes to a task in the listing, at the end of the text"), m_tryHead);
    m_toTask->setObjectName("toTask");
    for (PartLink *link : {m_toPredictions, m_toTask})
        showIcon(*link, "right", m_theme);
    connect(&m_room.bar(), &QScrollBar::valueChanged, this, &Narration::offerLinks);
    connect(&m_room.bar(), &QScrollBar::rangeChanged, this, &Narration::offerLinks);
    connect(m_toPredictions, &QToolButton::clicked, this, &Narration::goToPrediction);
    connect(m_toTask, &QToolButton::clicked, this, &Narration::goToTask);
    m_headGrid = new QGridLayout(m_tryHead);
    m_headGrid->setContentsMargins(18 - TryBox::left, 6, 18, 2);
    m_headGrid->setVerticalSpacing(0);
    m_headGrid->setColumnStretch(0, 1);
    m_headGrid->addWidget(m_heading, 0, 0);
    m_headGrid->addWidget(m_toPredictions, 0, 1, Qt::AlignLeft);
    m_headGrid->addWidget(m_toTask, 1, 1, Qt::AlignLeft);
}

void Narration::makeButtons()
{
    m_buttons = new StepButtons(m_theme, this);
    m_buttons->back().setAccessibleName(tr("Previous step"));
    connect(&m_buttons->back(), &QPushButton::clicked, &m_session, &Session::openPreceding);
    connect(&m_buttons->next(), &QPushButton::clicked, this, &Narration::goOn);
}

void Narration::open()
{
    const lessons::Step &step = m_session.step();
    m_title->setText(step.title);
    m_text->setText(step.narration);
    addPredictions();
    addWhys();
    addTasks();
    addTries();
    nameButtons();
    m_room.bar().setValue(0);
    fitText();
    m_isOpen = false; // tasks done earlier show their answers only on request
    showProgress();
    m_isOpen = true;
}

void Narration::addTries()
{
    qDeleteAll(m_tries);
    m_tries.clear();
    for (const lessons::Try &one : m_session.step().tries) {
        const std::size_t number = m_tries.size();
        m_tries.push_back(new TryBox(one, m_theme, m_tryPage));
        m_tries.back()->showHint(m_hints.contains(keyOf(number)));
        m_tryColumn->addWidget(m_tries.back());
        connect(m_tries.back(), &TryBox::hintToggled, this,
                [this, number](bool shown) { remember(number, shown); });
        for (const auto toggled : {&TryBox::answerToggled, &TryBox::choicesToggled})
            connect(m_tries.back(), toggled, this, [this, number] { makeRoomFor(number); });
        connect(m_tries.back(), &TryBox::chosen, this,
                [this, number](int chosen) { rememberChoice(number, chosen); });
        if (const Note *note = m_session.notes().find(keyOfChoice(number)))
            m_tries.back()->setChosen(note->said.toInt() - 1);
    }
    m_heading->setVisible(!m_tries.empty());
}

QString Narration::keyOfChoice(std::size_t number) const
{
    return Notes::keyOf(m_session.lesson().id, m_session.step().id, QStringLiteral("choice"),
                        m_session.step().tries[number].id);
}

void Narration::rememberChoice(std::size_t number, int chosen)
{
    const int right = m_session.step().tries[number].choices.right;
    m_session.notes().keep(keyOfChoice(number), {QStringLiteral("choice"), QString::number(chosen + 1),
                                                 QString::number(right + 1), chosen == right});
    makeRoomFor(number);
}

void Narration::makeRoomFor(std::size_t number)
{
    emit heightChanged();
    m_room.showTry(m_tries[number]);
}

void Narration::addPredictions()
{
    qDeleteAll(m_predictionBoxes);
    m_predictionBoxes.clear();
    const PredictionBox *first = nullptr; // of those without an answer: it is unfolded
    for (const lessons::Prediction &prediction : m_session.step().predictions) {
        auto *box = new PredictionBox(m_predictions, prediction, m_theme, m_room.page());
        m_predictionBoxes.push_back(box);
        m_predictionColumn->addWidget(box);
        if (!first && m_predictions.sheet(prediction.id).stage != PredictionDesk::Stage::shown) {
            first = box;
            box->setUnfolded(true);
        }
        connect(box, &PredictionBox::unfolded, this, [this, box](bool open) { showUnfolded(box, open); });
    }
    QTimer::singleShot(0, this, &Narration::offerLinks); // once the layout is done
    m_predictionHeading->setVisible(!m_predictionBoxes.empty());
    m_predictionColumn->setContentsMargins(0, m_predictionBoxes.empty() ? 0 : belowText, 0, 0);
}

void Narration::showPredictions()
{
    bool changed = false;
    PredictionBox *ended = nullptr; // its run was just played
    for (PredictionBox *box : m_predictionBoxes) {
        const bool wasActive = box->isActive();
        changed = box->refresh() || changed;
        if (wasActive && !box->isActive())
            ended = box;
    }
    changed = placeLinks() || changed; // the boxes can look the same: a question may be answered already
    offerLinks();
    if (!changed)
        return;
    if (ended)
        m_room.showWhole(ended); // the answer is at its end
    for (PredictionBox *box : m_predictionBoxes) {
        if (box->isPicking())
            m_room.showWhole(box);
    }
    fitText();
    emit heightChanged();
}

std::vector<PredictionBox *> Narration::openPredictions() const
{
    std::vector<PredictionBox *> open;
    std::copy_if(m_predictionBoxes.begin(), m_predictionBoxes.end(), std::back_inserter(open),
                 [this](const PredictionBox *box) {
                     return m_predictions.sheet(box->id()).stage != PredictionDesk::Stage::shown;
                 });
    return open;
}

std::vector<TaskBox *> Narration::openTasks() const
{
    std::vector<TaskBox *> open;
    std::copy_if(m_tasks.begin(), m_tasks.end(), std::back_inserter(open),
                 [this](const TaskBox *box) { return !m_desk.isDone(box->task()); });
    return open;
}

bool Narration::placeLinks()
{
    const bool hasPredictions = !openPredictions().empty(), hasTasks = !openTasks().empty();
    if (m_toPredictions->keepsPlace() == hasPredictions && m_toTask->keepsPlace() == hasTasks)
        return false;
    m_toPredictions->keepPlace(hasPredictions);
    m_toTask->keepPlace(hasTasks);
    // The panel is too narrow for two of them side by side.
    m_headGrid->removeWidget(m_toTask);
    m_headGrid->addWidget(m_toTask, hasPredictions ? 1 : 0, 1, Qt::AlignLeft);
    return true;
}

void Narration::offerLinks()
{
    m_toPredictions->offer(openPredictions(), m_room.viewport());
    m_toTask->offer(openTasks(), m_room.viewport());
}

void Narration::goToPrediction()
{
    const std::vector<PredictionBox *> open = openPredictions();
    if (open.empty())
        return;
    open.front()->focusField();
    m_room.showWhole(open.front());
    fitText();
    emit heightChanged();
}

void Narration::goToTask()
{
    const std::vector<TaskBox *> open = openTasks();
    if (open.empty())
        return;
    open.front()->setUnfolded(true);
    open.front()->focusTitle();
    m_room.showTopOf(open.front());
}

void Narration::addWhys()
{
    qDeleteAll(m_whys);
    m_whys.clear();
    emit highlightsChanged({});
    for (const lessons::Why &why : m_session.step().explanation.whys) {
        m_whys.push_back(new WhyBox(why, m_theme, m_room.page()));
        m_whyColumn->addWidget(m_whys.back());
        connect(m_whys.back(), &WhyBox::highlightsChanged, this, &Narration::highlightsChanged);
        connect(m_whys.back(), &WhyBox::unfolded, this,
                [this, box = m_whys.back()](bool open) { showUnfolded(box, open); });
    }
    m_whyColumn->setContentsMargins(0, m_whys.empty() ? 0 : 6, 0, 0);
}

void Narration::addTasks()
{
    qDeleteAll(m_tasks);
    m_tasks.clear();
    for (const lessons::CodeTask &task : m_session.step().codeTasks) {
        auto *box = new TaskBox(m_desk, task, m_theme, m_room.page());
        m_tasks.push_back(box);
        m_taskColumn->addWidget(box);
        connect(box, &TaskBox::unfolded, this, [this, box](bool open) { showUnfolded(box, open); });
        connect(box, &TaskBox::started, this,
                [this, &task] { emit listingRequested(m_session.step().listing.lineToWrite(task)); });
    }
    m_taskHeading->setVisible(!m_tasks.empty());
    placeLinks();
    const int above = m_whys.empty() ? belowText : belowWhys;
    m_taskColumn->setContentsMargins(0, m_tasks.empty() ? 0 : above, 0, 0);
}

void Narration::showTasks()
{
    bool changed = false;
    for (TaskBox *box : m_tasks)
        changed = box->refresh() || changed;
    changed = placeLinks() || changed;
    offerLinks();
    if (!changed)
        return;
    for (TaskBox *box : m_tasks) {
        if (m_desk.task() == &box->task())
            m_room.showWhole(box); // the judgement is at its end
    }
    fitText();
    emit heightChanged();
}

void Narration::showUnfolded(QWidget *box, bool open)
{
    fitText();
    emit heightChanged();
    if (open)
        m_room.showTopOf(box);
}

void Narration::setStepKeys(const QKeySequence &back, const QKeySequence &next)
{
    m_backKeys = back;
    m_nextKeys = next;
    nameButtons();
}

void Narration::nameButtons()
{
    const lessons::Step *before = m_session.run().preceding();
    m_buttons->back().setEnabled(before);
    m_buttons->back().setToolTip(before ? withKeys(tr("Back: %1").arg(before->title), m_backKeys)
                                        : tr("This is the first step."));
    const bool isLast = &m_session.step() == &m_session.lesson().steps.back();
    const QString next = isLast ? tr("What you learnt") : m_session.run().following()->title;
    m_buttons->next().setFullText(tr("Next: %1").arg(next), next);
    m_buttons->next().setToolTip(isLast ? tr("What you learnt in this lesson, and what comes next")
                                        : withKeys(tr("Next: %1").arg(next), m_nextKeys));
}

void Narration::goOn()
{
    if (&m_session.step() == &m_session.lesson().steps.back())
        emit summaryRequested();
    else
        m_session.openFollowing();
}

QString Narration::keyOf(std::size_t number) const
{
    return QStringLiteral("%1/%2/%3").arg(m_session.lesson().id, m_session.step().id).arg(number);
}

void Narration::remember(std::size_t number, bool shown)
{
    if (shown)
        m_hints.insert(keyOf(number));
    else
        m_hints.remove(keyOf(number));
    makeRoomFor(number);
}

void Narration::showNextHint()
{
    for (std::size_t i = 0; i < m_tries.size(); ++i) {
        if (m_tries[i]->hasHint() && !m_tries[i]->showsHint()) {
            m_tries[i]->showHint(true);
            remember(i, true);
            return;
        }
    }
}

void Narration::fitText()
{
    if (m_hasSize)
        m_room.fit(m_desk.task() ? leastTask : leastAbove);
}

void Narration::showProgress()
{
    const QString lesson = m_session.lesson().id;
    const QString step = m_session.step().id;
    for (std::size_t i = 0; i < m_tries.size(); ++i) {
        const bool isNew = !m_tries[i]->isDone();
        m_tries[i]->setDone(m_session.progress().isDone(lesson, step, static_cast<int>(i)));
        if (isNew && m_tries[i]->isDone() && m_isOpen)
            showAnswerOf(i);
    }
    m_buttons->next().setPrimary(m_session.isStepDone(m_session.lesson(), m_session.step()));
}

void Narration::showAnswerOf(std::size_t number)
{
    for (TryBox *one : m_tries) {
        if (one->isDone())
            one->showAnswer(one == m_tries[number]);
    }
    makeRoomFor(number);
}

void Narration::showTodos()
{
    for (std::size_t i = 0; i < m_tries.size(); ++i) {
        const int before = m_tries[i]->heightForWidth(width());
        if (!m_tries[i]->setTodo(m_session.todo(static_cast<int>(i))))
            continue;
        if (m_tries[i]->heightForWidth(width()) > before) // another number does not scroll
            makeRoomFor(i);
        else
            emit heightChanged();
    }
}

QSize Narration::minimumSizeHint() const
{
    return {200, 160};
}

bool Narration::eventFilter(QObject *watched, QEvent *event)
{
    // A scroll area does not tell its parents that its content needs another height.
    if (watched == m_tryPage && event->type() == QEvent::LayoutRequest)
        emit heightChanged();
    return QWidget::eventFilter(watched, event);
}

void Narration::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    m_hasSize = true;
    m_text->setLarge(window()->width() >= largeWindow);
    fitText();
}

}
