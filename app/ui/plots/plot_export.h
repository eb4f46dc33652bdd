#pragma once

#include "app/model/series/number_table.h"
#include "app/ui/plots/plot_picture.h"
#include "app/ui/theme/theme.h"

#include <QPointer>

#include <functional>

class QAction;
class QIODevice;
class QMenu;
class QToolButton;

namespace app {

/// Saves and copies a plot: as a picture, and where it has numbers, as those. One for each plot; its actions go into
/// the plot's menus.
class PlotExport : public QObject
{
    Q_OBJECT

public:
    using MakePicture = std::function<PlotPicture()>;
    using MakeNumbers = std::function<std::optional<NumberSheet>()>;
    using MakeText = std::function<QByteArray()>;

    /// `parent` owns this and is the parent of its dialogs.
    PlotExport(MakePicture picture, const Theme &theme, QWidget *parent);
    /// Adds the action that saves numbers. `numbers` returns nothing while there are none.
    void setNumbers(MakeNumbers numbers);
    /// Adds the same action for numbers that need not be computed: `text` returns the table as comma-separated text, or
    /// nothing while there is none.
    void setNumbersAsText(MakeText text);

    void addTo(QMenu &menu);
    /// Returns a button with a menu of all actions.
    QToolButton *makeButton(QWidget *parent);
    void addContextMenu(QWidget &plot);
    /// Writes a PNG, SVG or PDF, by the ending of the name; a name without one of these becomes a PNG. Returns whether
    /// it was written.
    bool savePicture(QString path);
    void copyPicture();
    /// Writes the numbers, or starts to: see NumberTable.
    void saveNumbers(const QString &path);
    /// Returns the table that is being written; null for none.
    NumberTable *table() const { return m_table; }

signals:
    /// Emitted with one sentence: what was saved or copied, or why it was not.
    void messageRequested(const QString &sentence);
    void failed(const QString &sentence);
    /// Emitted when writing numbers starts and ends.
    void tableChanged();

private:
    void addNumbersAction(const QString &tip);
    void askPicture();
    void askNumbers();
    void saveText(const QString &path);
    void computeNumbers(const QString &path);
    /// Writes a file and reports the result. Returns whether it was written.
    bool commit(const QString &path, const QString &failure, const std::function<bool(QIODevice &)> &write);
    bool write(QIODevice &file, const QString &suffix) const;
    QWidget *window() const;

    MakePicture m_picture;
    MakeNumbers m_numbers;
    MakeText m_text;
    const Theme &m_theme;
    QAction *m_savePicture;
    QAction *m_copyPicture;
    QAction *m_saveNumbers = nullptr;
    QPointer<NumberTable> m_table;
};

}
