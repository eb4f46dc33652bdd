#include "app/ui/window/experiment_files.h"

#include "app/model/experiment/experiment_line.h"
#include "app/model/files/recent_files.h"
#include "app/model/lesson_folders/lesson_package.h"
#include "app/model/text/quoting.h"
#include "app/ui/dialogs/ask_file.h"
#include "app/ui/dialogs/notice.h"
#include "app/ui/dialogs/report_errors.h"

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

/// Returns the file that is dragged over the window, or an empty path for anything else, such as several files.
QString fileOf(const QMimeData *data)
{
    const QList<QUrl> urls = data->urls();
    return urls.size() == 1 ? urls.front().toLocalFile() : QString();
}

}

ExperimentFiles::ExperimentFiles(Session &session, Notice &notice, QWidget &window)
    : m_session(session), m_notice(notice), m_window(window), m_document(session)
{
    window.setAcceptDrops(true);
    window.installEventFilter(this);
    connect(&m_document, &Document::stateChanged, this, &ExperimentFiles::showTitle);
    m_session.onChange(ChangeKind::step | ChangeKind::texts, this, &ExperimentFiles::showTitle);
    showTitle();
}

void ExperimentFiles::showTitle()
{
    const QString path = m_document.path();
    const QString name = path.isEmpty() ? m_session.step().title : shownPath(QFileInfo(path).fileName());
    m_window.setWindowTitle(tr("%1[*] – Springstep").arg(name));
    m_window.setWindowModified(m_document.isChanged());
}

bool ExperimentFiles::opens(const std::function<void()> &action)
{
    const bool isOpen =
        attempt(m_notice, tr("Could not open the experiment: %1 Your scene is unchanged."), action);
    if (isOpen)
        m_notice.showMessage({});
    return isOpen;
}

void ExperimentFiles::open(const QString &path)
{
    if (isLessonPath(path))
        emit lessonChosen(path);
    else if (opens([&] { m_document.open(path); }))
        addRecentFile(path);
}

void ExperimentFiles::openOrAsk(const QString &path)
{
    if (isLessonPath(path))
        open(path);
    else
        unlessLost([this, path] { open(path); });
}

bool ExperimentFiles::save(const QString &path)
{
    if (!attempt(m_notice, tr("Could not save the experiment: %1"), [&] { m_document.save(path); }))
        return false;
    addRecentFile(path);
    m_session.showMessage(tr("Saved as %1.").arg(shownPath(QFileInfo(path).fileName())));
    return true;
}

void ExperimentFiles::unlessLost(const std::function<void()> &action)
{
    if (!m_document.isChanged()) {
        action();
        return;
    }
    const QString path = m_document.path();
    const QString sentence = path.isEmpty()
                                 ? tr("“%1” has unsaved changes.").arg(m_session.step().title)
                                 : tr("%1 has unsaved changes.").arg(shownPath(QFileInfo(path).fileName()));
    const auto save = [this, action] {
        if (saveOrAsk())
            action();
    };
    m_notice.ask(sentence,
                 {{tr("Save"), tr("Save the changes, then continue"), save},
                  {tr("Discard changes"), tr("Continue without saving: your changes are lost"), action}});
}

void ExperimentFiles::askOpen()
{
    const QString path =
        askWhatToOpen(&m_window, tr("Open an experiment or a lesson"), m_document.path(),
                      tr("Experiments and lessons (*.springstep *.json *%1)").arg(lessonEnding));
    if (!path.isEmpty())
        openOrAsk(path);
}

bool ExperimentFiles::askSave()
{
    const QString path = m_document.path();
    const QString suggestion = path.isEmpty() ? m_session.step().id + ".springstep" : path;
    const QString chosen = askWhereToSave(&m_window, tr("Save the experiment"), suggestion,
                                          tr("Experiments (*.springstep *.json)"));
    return !chosen.isEmpty() && save(chosen);
}

bool ExperimentFiles::saveOrAsk()
{
    const QString path = m_document.path();
    return path.isEmpty() ? askSave() : save(path);
}

void ExperimentFiles::startNew()
{
    const auto action = [this] {
        m_document.startNew();
        m_session.showMessage(tr("The step has its published state again."));
    };
    // Without a file nothing is lost, because undo brings the scene back.
    m_document.path().isEmpty() ? action() : unlessLost(action);
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
        QAction *none = menu.addAction(tr("No recent files"));
        none->setToolTip(tr("Experiments that you open or save are listed here"));
        none->setEnabled(false);
    }
}

void ExperimentFiles::openRecent(const QString &path)
{
    if (QFileInfo::exists(path)) {
        openOrAsk(path);
        return;
    }
    dropRecentFile(path);
    m_notice.showMessage(
        tr("Could not find %1, so it was removed from the list. If you moved it, open it from its new "
           "place.")
            .arg(path));
}

void ExperimentFiles::copyAsText()
{
    QString line;
    if (!attempt(m_notice, tr("Could not copy the experiment: %1"),
                 [&] { line = experimentLine(m_session.experiment(), m_session.library()); }))
        return;
    QGuiApplication::clipboard()->setText(line);
    m_session.showMessage(
        tr("Copied: %n character(s), in one line.", nullptr, static_cast<int>(line.size())));
}

void ExperimentFiles::pasteText()
{
    const QString text = QGuiApplication::clipboard()->text();
    std::optional<Experiment> pasted;
    if (opens([&] { pasted = experimentFromLine(text, m_session.library()); }))
        unlessLost([this, pasted] { opens([&] { m_document.open(*pasted); }); });
}

bool ExperimentFiles::eventFilter(QObject *, QEvent *event)
{
    const QEvent::Type type = event->type();
    return (type == QEvent::DragEnter || type == QEvent::DragMove || type == QEvent::Drop) &&
           takesDrop(static_cast<QDropEvent &>(*event));
}

bool ExperimentFiles::takesDrop(QDropEvent &event)
{
    const QString path = fileOf(event.mimeData());
    if (path.isEmpty())
        return false;
    event.setDropAction(Qt::CopyAction);
    event.accept();
    if (event.type() == QEvent::Drop)
        openOrAsk(path);
    return true;
}

bool ExperimentFiles::mayClose()
{
    for (const StepName &name : m_document.changed()) {
        const QString path = m_document.pathOf(name);
        if (path.isEmpty())
            continue; // the next start recovers it
        QMessageBox question(QMessageBox::NoIcon, tr("Springstep"),
                             tr("%1 has unsaved changes.").arg(shownPath(QFileInfo(path).fileName())),
                             QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
        question.setDefaultButton(QMessageBox::Save);
        question.button(QMessageBox::Save)->setText(tr("&Save"));
        question.button(QMessageBox::Discard)->setText(tr("Close &without saving"));
        question.button(QMessageBox::Cancel)->setText(tr("&Cancel"));
        const int answer = question.exec();
        if (answer == QMessageBox::Cancel)
            return false;
        if (answer == QMessageBox::Discard)
            m_document.giveUp(name);
        else if (!attempt(m_notice, tr("Could not save the experiment: %1"),
                          [&] { m_document.save(name, path); }))
            return false;
    }
    return true;
}

}
