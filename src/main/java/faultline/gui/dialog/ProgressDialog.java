package faultline.gui.dialog;

import faultline.gui.action.QuitKey;
import faultline.gui.document.TaskProgress;
import faultline.gui.theme.DialogButtons;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.Window;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Supplier;
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
    private static final int STEP = 8;
    /** The height of a title bar that the window manager may add to another dialog, pixels, or more. */
    private static final int TITLE_HEIGHT = 40;

    private final JProgressBar progressBar = new JProgressBar(0, PROGRESS_STEPS);

    /**
     * Creates a dialog that is not yet visible.
     *
     * @param owner the window that it belongs to
     * @param title returns its title in the current language
     * @param modality which windows it blocks
     * @param sentence returns what it says, in the current language
     * @param cancel cancels the task
     */
    public ProgressDialog(
            Window owner, Supplier<String> title, ModalityType modality, Supplier<String> sentence, Runnable cancel) {
        super(owner, modality);
        RefreshSteps.add(getRootPane(), root -> setTitle(title.get()));
        RefreshSteps.add(progressBar, bar -> bar.getAccessibleContext().setAccessibleName(sentence.get()));
        JPanel content = new JPanel(new BorderLayout(0, 12));
        content.setBorder(BorderFactory.createEmptyBorder(16, 16, 12, 16));
        content.add(RefreshSteps.add(new JLabel(), label -> label.setText(sentence.get())), BorderLayout.NORTH);
        content.add(progressBar, BorderLayout.CENTER);
        content.add(DialogButtons.createSingleButton(this, "wait.cancel", cancel), BorderLayout.SOUTH);
        setContentPane(content);
        getRootPane().setDefaultButton(null);
        QuitKey.install(this);
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
        List<Rectangle> taken = Stream.of(owner.getOwnedWindows())
                .filter(window -> window instanceof ProgressDialog && window.isShowing())
                .map(Window::getBounds)
                .toList();
        taken.forEach(bounds -> bounds.grow(0, TITLE_HEIGHT));
        double bottom = getGraphicsConfiguration().getBounds().getMaxY();
        while (taken.stream().anyMatch(bounds -> bounds.intersects(getBounds()))
                && getBounds().getMaxY() + STEP < bottom) {
            setLocation(getX(), getY() + STEP);
        }
    }

    /** Shows the completed share. */
    public void setProgress(TaskProgress progress) {
        OptionalDouble share = progress.fraction();
        progressBar.setIndeterminate(share.isEmpty());
        share.ifPresent(known -> progressBar.setValue((int) (PROGRESS_STEPS * known)));
    }
}
