#pragma once

#include "app/model/catalog/lesson_library.h"
#include "app/model/files/autosave.h"
#include "app/ui/theme/theme.h"

#include <QDialog>
#include <QTimer>

#include <vector>

class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace app {

/// Returns a short text for a time: "12:41", or with the date if it is not today.
QString timeOf(const QDateTime &when);

/// A dialog that lists the scenes autosaved by earlier program starts: title, length of the run, time of the
/// last change, and a picture. Return recovers the selected scene, Del deletes it.
class RecoveryList : public QDialog
{
    Q_OBJECT

public:
    /// The library and the theme must outlive the list.
    RecoveryList(const LessonLibrary &library, const Theme &theme, QWidget *parent);

    /// Lists these scenes in the given order.
    void list(const std::vector<RecoveredScene> &scenes);

signals:
    void recovers(const app::RecoveredScene &scene);
    void deletes(const app::RecoveredScene &scene);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void addRow(const RecoveredScene &scene);
    /// Reads the frames and the picture of the next unread scene. It reads one scene at a time, because each
    /// may take long.
    void readNext();
    void read(QTreeWidgetItem &row, const RecoveredScene &scene) const;
    void recoverSelected();
    void deleteSelected();
    void refreshButtons();
    const RecoveredScene *selected() const;

    const LessonLibrary &m_library;
    const Theme &m_theme;
    QTreeWidget *m_rows;
    QPushButton *m_recover;
    QPushButton *m_delete;
    std::vector<RecoveredScene> m_scenes; ///< one per row
    QTimer m_timer;
    std::size_t m_read = 0; ///< number of rows that have their frames and picture
};

}
