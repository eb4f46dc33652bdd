#include "app/ui/learn/lessons/lesson_model.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

/// The id of top-level rows. The id of a step's row is the index of its lesson plus one.
constexpr quintptr topLevel = 0;

/// Returns the number of rows of the learner's lessons, with their heading.
int yourRows(const LessonLibrary &library)
{
    return library.yours.empty() ? 0 : static_cast<int>(library.yours.size()) + 1;
}

QString openLine()
{
    return LessonModel::tr("open");
}

}

LessonModel::LessonModel(Session &session, QObject *parent)
    : QAbstractItemModel(parent), m_session(session), m_shape(shape())
{
    session.onChange(ChangeKind::step | ChangeKind::texts, this, &LessonModel::refresh);
    connect(&session.progress(), &Progress::changed, this, &LessonModel::refresh);
}

void LessonModel::refresh()
{
    if (std::vector<std::size_t> now = shape(); now != m_shape) {
        beginResetModel();
        m_shape = std::move(now);
        endResetModel();
    }
    emit dataChanged(index(0, 0), index(rowCount() - 1, 0));
    for (int i = 0; i < rowCount(); ++i) {
        const QModelIndex row = index(i, 0);
        if (const int steps = rowCount(row))
            emit dataChanged(index(0, 0, row), index(steps - 1, 0, row));
    }
}

QModelIndex LessonModel::openLesson() const
{
    for (int row = 0; row < rowCount(); ++row) {
        const LessonEntry *lesson = lessonAt(row);
        if (lesson && isOpen(*lesson))
            return index(row, 0);
    }
    return {};
}

QModelIndex LessonModel::openRow() const
{
    const QModelIndex lesson = openLesson();
    if (!lesson.isValid())
        return {};
    const auto &steps = m_session.lesson().steps;
    const auto row =
        m_summaryShown ? static_cast<std::ptrdiff_t>(steps.size()) : &m_session.step() - steps.data();
    return index(static_cast<int>(row), 0, lesson);
}

void LessonModel::setSummaryShown(bool shown)
{
    if (shown == m_summaryShown)
        return;
    m_summaryShown = shown;
    refresh();
}

void LessonModel::open(const QModelIndex &index)
{
    if (!index.isValid() || kindOf(index) == Kind::problem || kindOf(index) == Kind::heading)
        return;
    const LessonEntry &lesson = lessonOf(index);
    if (kindOf(index) == Kind::summary) {
        if (!isOpen(lesson))
            m_session.openStep(lesson.id, lesson.steps.back().id);
        emit summaryRequested();
        return;
    }
    if (kindOf(index) == Kind::step) {
        const lessons::Step &step = lesson.steps[static_cast<std::size_t>(index.row())];
        if (&step == &m_session.step() && m_summaryShown)
            emit stepRequested();
        else
            m_session.openStep(lesson.id, step.id);
        return;
    }
    if (isOpen(lesson))
        return;
    const auto next = std::find_if(lesson.steps.begin(), lesson.steps.end(), [&](const lessons::Step &step) {
        return !m_session.isStepDone(lesson, step);
    });
    m_session.openStep(lesson.id, (next == lesson.steps.end() ? lesson.steps.front() : *next).id);
}

int LessonModel::doneIn(const LessonEntry &lesson) const
{
    return static_cast<int>(
        std::count_if(lesson.steps.begin(), lesson.steps.end(),
                      [&](const lessons::Step &step) { return m_session.isStepDone(lesson, step); }));
}

int LessonModel::stepsDone() const
{
    int done = 0;
    for (const LessonEntry &lesson : m_session.library().lessons)
        done += doneIn(lesson);
    return done;
}

int LessonModel::stepCount() const
{
    int count = 0;
    for (const LessonEntry &lesson : m_session.library().lessons)
        count += static_cast<int>(lesson.steps.size());
    return count;
}

QModelIndex LessonModel::index(int row, int column, const QModelIndex &parent) const
{
    if (!hasIndex(row, column, parent))
        return {};
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : topLevel);
}

QModelIndex LessonModel::parent(const QModelIndex &child) const
{
    if (!child.isValid() || child.internalId() == topLevel)
        return {};
    return createIndex(static_cast<int>(child.internalId()) - 1, 0, topLevel);
}

int LessonModel::rowCount(const QModelIndex &parent) const
{
    const LessonLibrary &library = m_session.library();
    if (!parent.isValid())
        return static_cast<int>(library.lessons.size()) + yourRows(library) +
               (library.problems.empty() ? 0 : 1);
    return kindOf(parent) == Kind::lesson ? static_cast<int>(lessonOf(parent).steps.size()) + 1 : 0;
}

int LessonModel::columnCount(const QModelIndex &) const
{
    return 1;
}

LessonModel::Kind LessonModel::kindOf(const QModelIndex &index) const
{
    if (index.internalId() != topLevel)
        return index.row() < static_cast<int>(lessonOf(index).steps.size()) ? Kind::step : Kind::summary;
    const LessonLibrary &library = m_session.library();
    if (lessonAt(index.row()))
        return Kind::lesson;
    const bool isHeading = index.row() == static_cast<int>(library.lessons.size()) && !library.yours.empty();
    return isHeading ? Kind::heading : Kind::problem;
}

const LessonEntry &LessonModel::lessonOf(const QModelIndex &index) const
{
    return *lessonAt(index.internalId() == topLevel ? index.row() : static_cast<int>(index.internalId()) - 1);
}

const LessonEntry *LessonModel::lessonAt(int row) const
{
    const LessonLibrary &library = m_session.library();
    const auto number = static_cast<std::size_t>(row);
    if (number < library.lessons.size())
        return &library.lessons[number];
    const std::size_t before = library.lessons.size() + 1; // with the heading
    return number >= before && number - before < library.yours.size() ? &library.yours[number - before]
                                                                      : nullptr;
}

std::vector<std::size_t> LessonModel::shape() const
{
    std::vector<std::size_t> counts;
    for (int row = 0; row < rowCount(); ++row) {
        const LessonEntry *lesson = lessonAt(row);
        counts.push_back(lesson ? lesson->steps.size() : 0);
    }
    return counts;
}

Qt::ItemFlags LessonModel::flags(const QModelIndex &index) const
{
    if (!index.isValid() || kindOf(index) == Kind::heading)
        return Qt::NoItemFlags; // the arrow keys pass over a heading
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable;
}

QVariant LessonModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Kind kind = kindOf(index);
    if (role == kindRole)
        return static_cast<int>(kind);
    if (kind == Kind::problem)
        return problemData(role);
    if (kind == Kind::heading)
        return headingData(role);
    const LessonEntry &lesson = lessonOf(index);
    if (kind == Kind::lesson)
        return lessonData(lesson, role);
    if (kind == Kind::summary)
        return summaryData(lesson, role);
    return stepData(lesson, lesson.steps[static_cast<std::size_t>(index.row())], role);
}

QVariant LessonModel::lessonData(const LessonEntry &lesson, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
        return lesson.title;
    case Qt::ToolTipRole:
        return lesson.summary;
    case Qt::AccessibleTextRole:
        return tr("%1, %2 of %3 steps done").arg(lesson.title).arg(doneIn(lesson)).arg(lesson.steps.size());
    case doneRole:
        return doneIn(lesson);
    case countRole:
        return static_cast<int>(lesson.steps.size());
    case openRole:
        return isOpen(lesson);
    default:
        return {};
    }
}

QVariant LessonModel::stepData(const LessonEntry &lesson, const lessons::Step &step, int role) const
{
    const bool open = &step == &m_session.step() && !m_summaryShown;
    const bool done = m_session.isStepDone(lesson, step);
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
        return step.title;
    case Qt::AccessibleTextRole: {
        const QString text = done ? tr("%1, done").arg(step.title) : tr("%1, not yet done").arg(step.title);
        return open ? text + ", " + openLine() : text;
    }
    case doneRole:
        return done;
    case openRole:
        return open;
    default:
        return {};
    }
}

QVariant LessonModel::summaryData(const LessonEntry &lesson, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
        return tr("What you learnt");
    case Qt::ToolTipRole:
        return tr("A summary of this lesson, and the things that are still to try");
    case Qt::AccessibleTextRole:
        return tr("%1: what you learnt").arg(lesson.title);
    case openRole:
        return isOpen(lesson) && m_summaryShown;
    default:
        return {};
    }
}

QVariant LessonModel::headingData(int role)
{
    switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
        return tr("Yours");
    case Qt::ToolTipRole:
        return tr("Lessons that you opened with File > Open");
    default:
        return {};
    }
}

QVariant LessonModel::problemData(int role) const
{
    const std::vector<LessonProblem> &problems = m_session.library().problems;
    switch (role) {
    case Qt::DisplayRole:
        return problems.size() == 1 ? tr("1 file is not a lesson")
                                    : tr("%1 files are not lessons").arg(problems.size());
    case Qt::AccessibleTextRole:
    case Qt::ToolTipRole: {
        QStringList sentences;
        for (const LessonProblem &problem : problems)
            sentences.push_back(problem.why);
        return sentences.join('\n');
    }
    default:
        return {};
    }
}

}
