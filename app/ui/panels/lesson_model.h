#pragma once

#include "app/model/session.h"

#include <QAbstractItemModel>

namespace app {

/// The lessons with their steps, how far the learner is, and a last row for files that are not lessons.
class LessonModel : public QAbstractItemModel
{
    Q_OBJECT

public:
    enum class Kind { lesson, step, summary, problem };
    enum Role {
        kindRole = Qt::UserRole, ///< Kind as a number
        doneRole,                ///< lesson: steps done; step: whether it is done
        countRole,               ///< lesson: how many steps
        openRole,                ///< whether this lesson, step or summary is the open one
    };

    explicit LessonModel(Session &session, QObject *parent = nullptr);

    QModelIndex openLesson() const;
    /// The row of the open step, or that of the lesson's summary while it is shown.
    QModelIndex openRow() const;
    void setSummaryShown(bool shown);
    /// Opens what the row stands for: a step, the first step of a lesson that is not done, a summary.
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
    /// The summary of the open lesson was asked for.
    void summaryAsked();
    /// The open step was asked for, which is open already.
    void stepAsked();

private:
    QVariant lessonData(const LessonEntry &lesson, int role) const;
    QVariant stepData(const LessonEntry &lesson, const lessons::Step &step, int role) const;
    QVariant summaryData(const LessonEntry &lesson, int role) const;
    QVariant problemData(int role) const;
    Kind kindOf(const QModelIndex &index) const;
    const LessonEntry &lessonOf(const QModelIndex &index) const;
    int doneIn(const LessonEntry &lesson) const;
    bool isOpen(const LessonEntry &lesson) const { return &lesson == &m_session.lesson(); }
    void refresh();

    Session &m_session;
    bool m_summaryShown = false;
};

}
