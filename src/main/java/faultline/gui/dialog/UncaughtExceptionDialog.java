package faultline.gui.dialog;

import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.gui.text.TextWrap;
import java.awt.EventQueue;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.logging.Level;
import java.util.logging.Logger;
import javax.swing.JOptionPane;

/**
 * Reports an internal error in one sentence; the details go to the log. Only one dialog is shown at a time, because an
 * error in painting would repeat with every frame.
 */
public final class UncaughtExceptionDialog implements Thread.UncaughtExceptionHandler {

    private static final Logger LOG = Logger.getLogger(UncaughtExceptionDialog.class.getName());

    private final AtomicBoolean showing = new AtomicBoolean();

    @Override
    public void uncaughtException(Thread thread, Throwable fault) {
        if (!isReported(fault)) {
            LOG.log(Level.FINE, fault, () -> "no preferences on thread " + thread.getName());
            return;
        }
        LOG.log(Level.SEVERE, fault, () -> "uncaught on thread " + thread.getName());
        if (showing.compareAndSet(false, true)) {
            EventQueue.invokeLater(() -> showFault(fault));
        }
    }

    /**
     * Returns whether the user must know of an error. The JDK also writes preferences on a thread of its own, which
     * fails if the disk is full, and nothing of the user's work is concerned.
     */
    static boolean isReported(Throwable fault) {
        return Arrays.stream(fault.getStackTrace())
                .noneMatch(frame -> frame.getClassName().startsWith("java.util.prefs."));
    }

    private void showFault(Throwable fault) {
        try {
            String sentence = TextWrap.wrap(Messages.get("uncaught.sentence", ErrorMessages.describe(fault)));
            JOptionPane.showMessageDialog(null, sentence, Messages.get("uncaught.title"), JOptionPane.ERROR_MESSAGE);
        } finally {
            showing.set(false);
        }
    }
}
