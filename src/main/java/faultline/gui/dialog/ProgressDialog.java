package faultline.gui.dialog;

import faultline.gui.document.TaskProgress;
import faultline.gui.theme.DialogButtons;
import faultline.gui.theme.TextSize;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.LayoutFocusTraversalPolicy;

/**
 * Shows the progress of a slow task. Its button, Escape and closing the dialog cancel the task. The dialog opens while
 * the user may be typing, so the button has the focus only after Tab.
 */
public final class ProgressDialog extends JDialog {

    private static final int PROGRESS_STEPS = 1000;
    private static final int WIDTH = 380;
    private static final int GAP = 8;

    private final JProgressBar progressBar = new JProgressBar(0, PROGRESS_STEPS);

    /** Creates a dialog that is not yet visible, given what its sentence says and what cancels the task. */
    public ProgressDialog(Window owner, String title, ModalityType modality, String sentence, Runnable cancel) {
        super(owner, title, modality);
        setDefaultCloseOperation(DO_NOTHING_ON_CLOSE);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                cancel.run();
            }
        });
        progressBar.getAccessibleContext().setAccessibleName(sentence);
        JPanel content = new JPanel(new BorderLayout(0, 12));
        content.setBorder(BorderFactory.createEmptyBorder(16, 16, 12, 16));
        content.add(new JLabel(sentence), BorderLayout.NORTH);
        content.add(progressBar, BorderLayout.CENTER);
        content.add(DialogButtons.createSingleButton(this, "wait.cancel", cancel), BorderLayout.SOUTH);
        setContentPane(content);
        getRootPane().setDefaultButton(null);
        progressBar.setFocusable(true);
        setFocusTraversalPolicy(new LayoutFocusTraversalPolicy() {
            @Override
            public Component getInitialComponent(Window window) {
                return progressBar;
            }
        });
        progressBar.setIndeterminate(true);
        pack();
        setSize(new Dimension(Math.max(TextSize.scaled(WIDTH), getWidth()), getHeight()));
        setResizable(false);
        setLocationRelativeTo(owner);
        avoidOthers(owner);
    }

    /** Moves this dialog down until it covers no other one of its kind and owner, if the screen has room. */
    private void avoidOthers(Window owner) {
        List<Window> others = Stream.of(owner.getOwnedWindows())
                .filter(window -> window instanceof ProgressDialog && window.isShowing())
                .toList();
        double bottom = getGraphicsConfiguration().getBounds().getMaxY();
        while (others.stream().anyMatch(other -> other.getBounds().intersects(getBounds()))
                && getBounds().getMaxY() + GAP < bottom) {
            setLocation(getX(), getY() + GAP);
        }
    }

    /** Shows the completed share. */
    public void setProgress(TaskProgress progress) {
        OptionalDouble share = progress.fraction();
        progressBar.setIndeterminate(share.isEmpty());
        share.ifPresent(known -> progressBar.setValue((int) (PROGRESS_STEPS * known)));
    }
}
