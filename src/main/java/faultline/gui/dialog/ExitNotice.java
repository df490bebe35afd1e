package faultline.gui.dialog;

import faultline.gui.text.Messages;
import faultline.gui.text.TextWrap;
import java.awt.EventQueue;
import javax.swing.JDialog;
import javax.swing.JOptionPane;
import javax.swing.Timer;

/**
 * Asks what to do if the program cannot end soon after its window was closed, because something is still being written.
 * Only the user ends the program before that: a slow disk may need longer than any limit. A question that is closed is
 * asked again later. Event dispatch thread only.
 */
public final class ExitNotice {

    /** More than a controller has to end, which writes no file. */
    private static final int DELAY_MILLIS = 15_000;

    private final Runnable exit;
    private final Timer timer;
    /** Null before it opens. */
    private JDialog dialog;

    /** Starts to wait; {@code exit} ends the program on request. */
    public ExitNotice(Runnable exit) {
        this(exit, DELAY_MILLIS);
    }

    ExitNotice(Runnable exit, int delayMillis) {
        assert EventQueue.isDispatchThread();
        this.exit = exit;
        timer = new Timer(delayMillis, event -> show());
        timer.setRepeats(false);
        timer.start();
    }

    private void show() {
        close();
        String exitNow = Messages.get("exit.now");
        String[] answers = {Messages.get("exit.wait"), exitNow};
        JOptionPane pane = new JOptionPane(
                TextWrap.wrap(Messages.get("exit.busy")),
                JOptionPane.WARNING_MESSAGE,
                JOptionPane.DEFAULT_OPTION,
                null,
                answers,
                answers[0]);
        dialog = pane.createDialog(Messages.get("exit.title"));
        dialog.setModal(false);
        dialog.setIconImages(AppIcon.images());
        pane.addPropertyChangeListener(JOptionPane.VALUE_PROPERTY, answer -> {
            if (exitNow.equals(answer.getNewValue())) {
                exit.run();
            } else {
                timer.restart();
            }
        });
        dialog.setVisible(true);
    }

    /** Ends the wait, because the program can end. */
    public void close() {
        timer.stop();
        if (dialog != null) {
            dialog.dispose();
        }
    }
}
