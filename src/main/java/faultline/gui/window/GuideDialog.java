package faultline.gui.window;

import faultline.gui.text.Texts;
import faultline.gui.theme.TextSize;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Window;
import java.util.concurrent.ExecutionException;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.SwingWorker;

/** The short guide, beside the window rather than in its way. */
final class GuideDialog extends JDialog {

    private static final Dimension SIZE = new Dimension(620, 560);

    private GuideDialog(Window owner, GuidePage page) {
        super(owner, Texts.text("guide.title"), ModalityType.MODELESS);
        JPanel content = new JPanel(new BorderLayout(0, 12));
        content.setBorder(BorderFactory.createEmptyBorder(16, 16, 12, 16));
        JScrollPane scroll = new JScrollPane(page.pane());
        scroll.setPreferredSize(new Dimension(TextSize.scaled(SIZE.width), SIZE.height));
        content.add(scroll, BorderLayout.CENTER);
        content.add(buttons(), BorderLayout.SOUTH);
        setContentPane(content);
        pack();
        setLocationRelativeTo(owner);
    }

    /** Shows the guide, soon, or brings it to the front where it is open. */
    static void open(Window owner) {
        if (!Dialogs.isBroughtToFront(owner, GuideDialog.class)) {
            read(owner);
        }
    }

    private static void read(Window owner) {
        new SwingWorker<GuidePage, Void>() {
            @Override
            protected GuidePage doInBackground() {
                return GuidePage.read();
            }

            @Override
            protected void done() {
                try {
                    show(owner, get());
                } catch (ExecutionException broken) {
                    throw new IllegalStateException(broken.getCause());
                } catch (InterruptedException broken) {
                    Thread.currentThread().interrupt();
                }
            }
        }.execute();
    }

    private static void show(Window owner, GuidePage page) {
        // Another may have been asked for, and have come, while this page was read.
        if (!Dialogs.isBroughtToFront(owner, GuideDialog.class)) {
            new GuideDialog(owner, page).setVisible(true);
        }
    }

    private JPanel buttons() {
        JButton close = new JButton(Texts.text("dialog.close"));
        close.addActionListener(event -> dispose());
        getRootPane().setDefaultButton(close);
        getRootPane().registerKeyboardAction(event -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING, 0, 0));
        buttons.add(close);
        return buttons;
    }
}
