#pragma once

#include "app/model/lesson_library.h"
#include "app/model/scene_keeper.h"
#include "app/ui/theme/theme.h"

#include <QDialog>
#include <QTimer>

#include <vector>

class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace app {

/// Returns a time in a few words: "12:41", or with the day if that is another.
QString timeOf(const QDateTime &when);

/// The scenes that programs before have kept, as a list: what each is, how long its run is, when it was last changed, and
/// a picture. Return recovers the selected one, Del deletes it.
class KeptList : public QDialog
{
    Q_OBJECT

public:
    /// Library and theme must outlive it.
    KeptList(const LessonLibrary &library, const Theme &theme, QWidget *parent);

    /// Lists these scenes, in their order.
    void list(const std::vector<KeptScene> &scenes);

signals:
    void recovers(const app::KeptScene &scene);
    void deletes(const app::KeptScene &scene);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void addRow(const KeptScene &scene);
    /// Reads the next scene that was not read yet: its frames and its picture. One at a time, as it may take long.
    void readNext();
    void read(QTreeWidgetItem &row, const KeptScene &scene) const;
    void recoverSelected();
    void deleteSelected();
    void refreshButtons();
    const KeptScene *selected() const;

    const LessonLibrary &m_library;
    const Theme &m_theme;
    QTreeWidget *m_rows;
    QPushButton *m_recover;
    QPushButton *m_delete;
    std::vector<KeptScene> m_scenes; ///< one a row
    QTimer m_later;
    std::size_t m_read = 0; ///< rows that have their frames and picture
};

}
