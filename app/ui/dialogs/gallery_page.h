#pragma once

#include "app/model/files/gallery.h"
#include "app/ui/theme/theme.h"

#include <QDialog>

#include <functional>

class QLabel;
class QListWidget;
class QPushButton;

namespace app {

/// A dialog with a card for each experiment in the gallery. Return opens one, F2 renames it, Del removes it, and Ctrl+Z
/// takes the last change back.
class GalleryPage : public QDialog
{
    Q_OBJECT

public:
    /// The arguments must outlive this object.
    GalleryPage(Gallery &gallery, const Theme &theme, QWidget *parent);

    /// Reads the folder again, and shows the dialog in front.
    void open() override;

signals:
    /// The learner wants to keep the present experiment.
    void keepRequested();
    void opens(const app::KeptExperiment &kept);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QPushButton *addButton(const QString &name, const QString &text, const QString &tip);
    void list();
    void refreshButtons();
    const KeptExperiment *selected() const;
    void openSelected();
    void renameSelected();
    void removeSelected();
    void undo();
    /// Runs `action`, which changes files, and shows why it failed.
    void attemptChange(const std::function<void()> &action);

    Gallery &m_gallery;
    const Theme &m_theme;
    QListWidget *m_cards;
    QLabel *m_empty;
    QLabel *m_mistakes;
    QWidget *m_row; ///< of the buttons
    QPushButton *m_open;
    QPushButton *m_rename;
    QPushButton *m_remove;
    QPushButton *m_undo;
    QString m_failure;        ///< of the last change
    bool m_isListing = false; ///< whether the cards change because the gallery did
};

}
