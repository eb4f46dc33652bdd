#pragma once

#include "app/model/session/session.h"

#include <QAbstractItemModel>

#include <vector>

namespace app {

/// A model of the lessons, their steps and the learner's progress: the lessons of the program, then, below a heading, those
/// of the learner. A last row lists files that are not valid lessons.
class LessonModel : public QAbstractItemModel
{
    Q_OBJECT

public:
    enum class Kind { lesson, step, summary, heading, problem };
    enum Role {
        kindRole = Qt::UserRole, ///< the Kind as a number
        doneRole,                ///< lesson: number of steps done; step: whether it is done
        countRole,               ///< lesson: number of steps
        openRole,                ///< whether this lesson, step or summary is the open one
    };

    explicit LessonModel(Session &session, QObject *parent = nullptr);

    /// Returns the row of the open lesson; not valid if a sandbox is open.
    QModelIndex openLesson() const;
    /// Returns the row of the open step, or of the lesson's summary while that is shown.
    QModelIndex openRow() const;
    void setSummaryShown(bool shown);
    /// Opens the row's target: a step, the first unfinished step of a lesson, or a summary.
    void open(const QModelIndex &index);
    int stepsDone() const;
    int stepCount() const;

    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &child) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;

signals:
    /// Emitted when the learner asks for the summary of the open lesson.
    void summaryRequested();
    /// Emitted when the learner asks for the step that is already open.
    void stepRequested();

private:
    QVariant lessonData(const LessonEntry &lesson, int role) const;
    QVariant stepData(const LessonEntry &lesson, const lessons::Step &step, int role) const;
    QVariant summaryData(const LessonEntry &lesson, int role) const;
    static QVariant headingData(int role);
    QVariant problemData(int role) const;
    Kind kindOf(const QModelIndex &index) const;
    const LessonEntry &lessonOf(const QModelIndex &index) const;
    int doneIn(const LessonEntry &lesson) const;
    bool isOpen(const LessonEntry &lesson) const { return &lesson == &m_session.lesson(); }
    /// Returns the lesson of a top-level row; null if it is another kind of row.
    const LessonEntry *lessonAt(int row) const;
    /// Returns the number of steps in each lesson, which decides on the rows.
    std::vector<std::size_t> shape() const;
    void refresh();

    Session &m_session;
    bool m_summaryShown = false;
    std::vector<std::size_t> m_shape; ///< as the views know it
};

}
