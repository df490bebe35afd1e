package faultline.gui.batch;

import faultline.campaign.run.Outcome;
import faultline.external.ControllerChoice;
import faultline.gui.action.QuitKey;
import faultline.gui.dialog.Dialogs;
import faultline.gui.text.Messages;
import faultline.gui.theme.DialogButtons;
import faultline.gui.theme.ScreenFit;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.UiText;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Window;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;

/**
 * A non-modal dialog with the results of many runs. It is hidden when one of the runs is opened in the window, until
 * the user asks for it.
 */
abstract class RunsDialog extends JDialog {

    private static final Dimension SIZE = new Dimension(1080, 620);

    private final transient BatchActions actions;
    private final JTabbedPane tabs = new JTabbedPane();
    private final BatchProgressPanel progress = new BatchProgressPanel();
    /** Null without results. */
    private transient BatchResults results;
    /** Null without results. */
    private transient ResultTabs resultTabs;
    /** The controller of the results, or only the jars with it. */
    private transient ControllerChoice controller = ControllerChoice.SCENARIO;

    RunsDialog(Window owner, BatchActions actions) {
        super(owner, ModalityType.MODELESS);
        assert EventQueue.isDispatchThread();
        this.actions = actions;
        UiText.name(tabs, "batch.tabs");
        DialogButtons.onClose(this, this::close);
        QuitKey.install(this);
    }

    /** Lays out the tabs and, below them, the progress and some buttons. */
    final void layOut(List<JButton> buttons) {
        JPanel row = new WrappedRow();
        buttons.forEach(row::add);
        JPanel footer = new JPanel(new BorderLayout(0, 4));
        footer.add(progress, BorderLayout.CENTER);
        footer.add(row, BorderLayout.SOUTH);
        JPanel content = new JPanel(new BorderLayout(0, 8));
        content.setBorder(BorderFactory.createEmptyBorder(8, 12, 8, 12));
        content.add(tabs, BorderLayout.CENTER);
        content.add(footer, BorderLayout.SOUTH);
        setContentPane(content);
        int width = Math.max(TextSize.scaled(SIZE.width), content.getPreferredSize().width);
        content.setPreferredSize(new Dimension(width, TextSize.scaled(SIZE.height)));
        ScreenFit.pack(this);
        setLocationRelativeTo(getOwner());
    }

    static JButton button(String key, Runnable action) {
        JButton button = UiText.button(key);
        button.addActionListener(event -> action.run());
        return button;
    }

    /** Closes the dialog as its button does. */
    abstract void close();

    /**
     * Disposes of the dialog and gives the focus to its owner. A window manager may give it to no window if a question
     * above the dialog is closed at the same time.
     */
    final void disposeAndFocusOwner() {
        Component focused = lastFocused(getOwner());
        dispose();
        focused.requestFocus();
    }

    /** Returns the component of a window that had the focus last, or the window, in which keys have no effect. */
    private static Component lastFocused(Window window) {
        Component last = window.getMostRecentFocusOwner();
        return last != null && last.isShowing() && last.isEnabled() ? last : window;
    }

    final BatchActions actions() {
        return actions;
    }

    final JTabbedPane tabs() {
        return tabs;
    }

    final BatchProgressPanel progress() {
        return progress;
    }

    /** Returns the results, null for none. */
    final BatchResults resultsOrNull() {
        return results;
    }

    /** Returns the views of the results, null for none. */
    final ResultTabs resultTabsOrNull() {
        return resultTabs;
    }

    /** Shows results behind the other tabs, and makes their runs with a controller when they are opened. */
    final void showResults(BatchResults shown, ControllerChoice driving) {
        results = shown;
        controller = driving;
        resultTabs = new ResultTabs(tabs, shown, this::open);
        resultTabs.select();
        progress.showControllers(shown.plan().controllerTypes());
    }

    final void removeResults() {
        if (resultTabs != null) {
            resultTabs.remove();
        }
        results = null;
        resultTabs = null;
        progress.showControllers(List.of());
    }

    /** Shows the dialog where the user left it. */
    final void bringToFront() {
        setVisible(true);
        toFront();
        lastFocused(this).requestFocus();
        if (resultTabs != null) {
            resultTabs.focusTable();
        }
    }

    /** Opens the run of a row in the window. */
    private void open(int row) {
        if (results.value(row, "outcome").equals(Outcome.BROKEN)) {
            showProblem(Messages.get("batch.broken", results.value(row, "failure")));
        } else {
            actions.openRun(this, results, row, controller);
        }
    }

    /** Called when a run is open in the window. */
    void runOpened() {
        setVisible(false);
    }

    final void showProblem(String sentence) {
        Dialogs.showWarning(this, sentence);
    }
}
