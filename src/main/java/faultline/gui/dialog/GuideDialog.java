package faultline.gui.dialog;

import faultline.gui.document.BackgroundTasks;
import faultline.gui.text.Messages;
import faultline.gui.theme.DialogButtons;
import faultline.gui.theme.ScreenFit;
import faultline.gui.theme.TextSize;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Window;
import javax.swing.BorderFactory;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.JScrollPane;

/** The user guide in a non-modal dialog. */
final class GuideDialog extends JDialog {

    private static final Dimension SIZE = new Dimension(620, 560);

    private GuideDialog(Window owner, GuidePage page) {
        super(owner, Messages.get("guide.title"), ModalityType.MODELESS);
        JPanel content = new JPanel(new BorderLayout(0, 12));
        content.setBorder(BorderFactory.createEmptyBorder(16, 16, 12, 16));
        // A scroll bar that comes and goes would lay out the text twice.
        JScrollPane scroll = new JScrollPane(
                page.createPane(), JScrollPane.VERTICAL_SCROLLBAR_ALWAYS, JScrollPane.HORIZONTAL_SCROLLBAR_AS_NEEDED);
        scroll.setPreferredSize(new Dimension(TextSize.scaled(SIZE.width), SIZE.height));
        content.add(scroll, BorderLayout.CENTER);
        content.add(
                DialogButtons.createSingleButton(this, Messages.get("dialog.close"), this::dispose),
                BorderLayout.SOUTH);
        setContentPane(content);
    }

    /** Shows the guide asynchronously, or brings it to the front if it is open. */
    static void showGuide(Window owner) {
        if (!Dialogs.bringToFront(owner, GuideDialog.class)) {
            loadAndShow(owner);
        }
    }

    private static void loadAndShow(Window owner) {
        BackgroundTasks.run(GuidePage::load, page -> showPage(owner, page), failure -> {
            throw new IllegalStateException(failure);
        });
    }

    /** Creates the dialog, and lays it out in an event of its own, so that neither event takes long. */
    private static void showPage(Window owner, GuidePage page) {
        GuideDialog dialog = new GuideDialog(owner, page);
        EventQueue.invokeLater(() -> dialog.showUnlessOpen(owner));
    }

    private void showUnlessOpen(Window owner) {
        // Another guide may have been opened while this page was loading.
        if (Dialogs.bringToFront(owner, GuideDialog.class)) {
            dispose();
        } else {
            ScreenFit.pack(this);
            setLocationRelativeTo(owner);
            setVisible(true);
        }
    }
}
