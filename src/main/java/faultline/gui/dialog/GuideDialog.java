package faultline.gui.dialog;

import faultline.gui.action.QuitKey;
import faultline.gui.document.BackgroundTasks;
import faultline.gui.text.Messages;
import faultline.gui.theme.DialogButtons;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.ScreenFit;
import faultline.gui.theme.TextSize;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Window;
import java.util.concurrent.Callable;
import javax.swing.BorderFactory;
import javax.swing.JDialog;
import javax.swing.JEditorPane;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JViewport;

/** The user guide in a non-modal dialog. */
final class GuideDialog extends JDialog {

    private static final Dimension SIZE = new Dimension(620, 560);

    private final JEditorPane pane;
    /** Loads the page in the background. */
    private final transient Callable<GuidePage> loader;
    /** The number of times that the page has been loaded again. */
    private int loads;

    /** Creates a dialog that is not yet visible, given the first page and what loads a later one. */
    GuideDialog(Window owner, GuidePage page, Callable<GuidePage> loader) {
        super(owner, ModalityType.MODELESS);
        this.loader = loader;
        JPanel content = new JPanel(new BorderLayout(0, 12));
        content.setBorder(BorderFactory.createEmptyBorder(16, 16, 12, 16));
        // A scroll bar that comes and goes would lay out the text twice.
        pane = page.createPane();
        JScrollPane scroll = new JScrollPane(
                pane, JScrollPane.VERTICAL_SCROLLBAR_ALWAYS, JScrollPane.HORIZONTAL_SCROLLBAR_AS_NEEDED);
        scroll.setPreferredSize(new Dimension(TextSize.scaled(SIZE.width), SIZE.height));
        content.add(scroll, BorderLayout.CENTER);
        content.add(DialogButtons.createSingleButton(this, "dialog.close", this::dispose), BorderLayout.SOUTH);
        setContentPane(content);
        QuitKey.install(this);
        RefreshSteps.add(getRootPane(), root -> refresh());
    }

    /** Loads the page again after a change of language, text size or theme. */
    private void refresh() {
        setTitle(Messages.get("guide.title"));
        if (isShowing()) {
            int number = ++loads;
            BackgroundTasks.compute(
                    loader,
                    page -> {
                        // A page that was requested before a later change may be loaded last.
                        if (number == loads) {
                            replacePage(page);
                        }
                    },
                    failure -> {
                        throw new IllegalStateException(failure);
                    });
        }
    }

    /** Shows another page at the same position in the text; the layout is done in a separate event. */
    private void replacePage(GuidePage page) {
        JViewport viewport = (JViewport) pane.getParent();
        double share = (double) viewport.getViewPosition().y / viewport.getViewSize().height;
        page.showIn(pane);
        EventQueue.invokeLater(() -> {
            validate();
            int y = (int) Math.round(share * viewport.getViewSize().height);
            EventQueue.invokeLater(() -> viewport.setViewPosition(new Point(0, y)));
        });
    }

    /** Shows the guide asynchronously, or brings it to the front if it is open. */
    static void showGuide(Window owner) {
        if (!Dialogs.bringToFront(owner, GuideDialog.class)) {
            loadAndShow(owner);
        }
    }

    private static void loadAndShow(Window owner) {
        BackgroundTasks.compute(GuidePage::load, page -> showPage(owner, page), failure -> {
            throw new IllegalStateException(failure);
        });
    }

    /** Creates the dialog, lays it out and shows it, each in a separate event, so that no event takes long. */
    private static void showPage(Window owner, GuidePage page) {
        if (!owner.isShowing()) {
            // The owner has been closed. Packing its dialog would keep the program from exiting.
            return;
        }
        GuideDialog dialog = new GuideDialog(owner, page, GuidePage::load);
        EventQueue.invokeLater(() -> {
            ScreenFit.pack(dialog);
            EventQueue.invokeLater(() -> dialog.showUnlessOpen(owner));
        });
    }

    private void showUnlessOpen(Window owner) {
        // While this page was loading, the owner may have been closed, or another guide opened.
        if (!owner.isShowing() || Dialogs.bringToFront(owner, GuideDialog.class)) {
            dispose();
        } else {
            setLocationRelativeTo(owner);
            setVisible(true);
        }
    }
}
