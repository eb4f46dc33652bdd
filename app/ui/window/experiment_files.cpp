#include "app/ui/window/experiment_files.h"

#include "app/model/experiment_line.h"
#include "app/model/recent_files.h"
#include "app/model/words.h"
#include "app/ui/panels/ask_file.h"
#include "app/ui/window/attempt.h"
#include "app/ui/window/notice.h"

#include <QClipboard>
#include <QDropEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QUrl>
#include <QWidget>

namespace app {

namespace {

/// The file that is dragged over the window; empty: something else, or several.
QString fileOf(const QMimeData *data)
{
    const QList<QUrl> urls = data->urls();
    return urls.size() == 1 ? urls.front().toLocalFile() : QString();
}

}

ExperimentFiles::ExperimentFiles(Session &session, Notice &notice, QWidget &window)
    : m_session(session), m_notice(notice), m_window(window), m_document(session)
{
}

bool ExperimentFiles::opens(const std::function<void()> &deed)
{
    const bool isOpen = attempt(m_notice, tr("Experiment not opened: %1 Your scene is unchanged."), deed);
    if (isOpen)
        m_notice.say({});
    return isOpen;
}

void ExperimentFiles::open(const QString &path)
{
    if (opens([&] { m_document.open(path); }))
        addRecentFile(path);
}

bool ExperimentFiles::save(const QString &path)
{
    if (!attempt(m_notice, tr("Experiment not saved: %1"), [&] { m_document.save(path); }))
        return false;
    addRecentFile(path);
    emit said(tr("Saved as %1.").arg(shownPath(QFileInfo(path).fileName())));
    return true;
}

void ExperimentFiles::unlessLost(const std::function<void()> &deed)
{
    if (!m_document.isChanged()) {
        deed();
        return;
    }
    const QString path = m_document.path();
    const QString sentence =
        path.isEmpty() ? tr("What you did in “%1” is not saved.").arg(m_session.step().title)
                       : tr("%1 has changes that are not saved.").arg(shownPath(QFileInfo(path).fileName()));
    const auto save = [this, deed] {
        if (saveOrAsk())
            deed();
    };
    m_notice.ask(sentence, {{tr("Save it first"), tr("Save it, then go on"), save},
                            {tr("Go on without"), tr("Go on; what was not saved is gone"), deed}});
}

void ExperimentFiles::askOpen()
{
    const QString path =
        askWhatToOpen(&m_window, tr("Open an experiment"), m_document.path(), tr("Experiments (*.json)"));
    if (!path.isEmpty())
        unlessLost([this, path] { open(path); });
}

bool ExperimentFiles::askSave()
{
    const QString path = m_document.path();
    const QString suggestion = path.isEmpty() ? m_session.step().id + ".json" : path;
    const QString chosen =
        askWhereToSave(&m_window, tr("Save the experiment"), suggestion, tr("Experiments (*.json)"));
    return !chosen.isEmpty() && save(chosen);
}

bool ExperimentFiles::saveOrAsk()
{
    const QString path = m_document.path();
    return path.isEmpty() ? askSave() : save(path);
}

void ExperimentFiles::startNew()
{
    const auto deed = [this] {
        m_document.startNew();
        emit said(tr("The step as it is published."));
    };
    // Without a file nothing is lost: undo brings it back.
    m_document.path().isEmpty() ? deed() : unlessLost(deed);
}

void ExperimentFiles::fillRecent(QMenu &menu)
{
    menu.clear();
    int number = 0;
    for (const QString &path : recentFiles()) {
        const QFileInfo file(path);
        QAction *one = menu.addAction(
            tr("&%1  %2").arg(++number).arg(shownPath(file.fileName()).replace('&', QLatin1String("&&"))));
        one->setToolTip(path);
        connect(one, &QAction::triggered, this, [this, path] { openRecent(path); });
    }
    if (menu.isEmpty()) {
        QAction *none = menu.addAction(tr("No file yet"));
        none->setToolTip(tr("Experiments that you open or save will be listed here"));
        none->setEnabled(false);
    }
}

void ExperimentFiles::openRecent(const QString &path)
{
    if (QFileInfo::exists(path)) {
        unlessLost([this, path] { open(path); });
        return;
    }
    dropRecentFile(path);
    m_notice.say(tr("%1 is not there any more, and was taken out of the list. If you moved it, open it from "
                    "where it is now.")
                     .arg(path));
}

void ExperimentFiles::copyAsText()
{
    QString line;
    if (!attempt(m_notice, tr("Experiment not copied: %1"),
                 [&] { line = experimentLine(m_session.experiment(), m_session.library()); }))
        return;
    QGuiApplication::clipboard()->setText(line);
    emit said(tr("Copied: %n character(s), in one line.", nullptr, static_cast<int>(line.size())));
}

void ExperimentFiles::pasteText()
{
    const QString text = QGuiApplication::clipboard()->text();
    std::optional<Experiment> pasted;
    if (opens([&] { pasted = experimentFromLine(text, m_session.library()); }))
        unlessLost([this, pasted] { opens([&] { m_document.open(*pasted); }); });
}

bool ExperimentFiles::takesDrop(const QObject *watched, QEvent &event)
{
    if (event.type() != QEvent::DragEnter && event.type() != QEvent::DragMove && event.type() != QEvent::Drop)
        return false;
    const auto *widget = qobject_cast<const QWidget *>(watched);
    if (!widget || widget->window() != &m_window)
        return false;
    auto &drop = static_cast<QDropEvent &>(event);
    const QString path = fileOf(drop.mimeData());
    if (path.isEmpty())
        return false;
    drop.setDropAction(Qt::CopyAction);
    drop.accept();
    if (event.type() == QEvent::Drop)
        unlessLost([this, path] { open(path); });
    return true;
}

bool ExperimentFiles::mayClose()
{
    for (const StepName &name : m_document.changed()) {
        const QString path = m_document.pathOf(name);
        if (path.isEmpty())
            continue; // it is kept for the next start
        QMessageBox question(
            QMessageBox::NoIcon, tr("Springstep"),
            tr("%1 has changes that are not saved.").arg(shownPath(QFileInfo(path).fileName())),
            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
        question.setDefaultButton(QMessageBox::Save);
        question.button(QMessageBox::Save)->setText(tr("&Save"));
        question.button(QMessageBox::Discard)->setText(tr("Close &without saving"));
        question.button(QMessageBox::Cancel)->setText(tr("&Stay"));
        const int answer = question.exec();
        if (answer == QMessageBox::Cancel)
            return false;
        if (answer == QMessageBox::Discard)
            m_document.giveUp(name);
        else if (!attempt(m_notice, tr("Experiment not saved: %1"), [&] { m_document.save(name, path); }))
            return false;
    }
    return true;
}

}
