package faultline.gui.window;

import faultline.gui.text.Reasons;
import faultline.gui.text.Texts;
import java.awt.EventQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.logging.Level;
import java.util.logging.Logger;
import javax.swing.JOptionPane;

/**
 * Tells the user of a fault of the program itself in one sentence; the details go to the log. One dialog at a time, or a fault in painting
 * would fill the screen.
 */
public final class UncaughtDialog implements Thread.UncaughtExceptionHandler {

    private static final Logger LOG = Logger.getLogger(UncaughtDialog.class.getName());

    private final AtomicBoolean showing = new AtomicBoolean();

    @Override
    public void uncaughtException(Thread thread, Throwable fault) {
        LOG.log(Level.SEVERE, fault, () -> "uncaught on thread " + thread.getName());
        if (showing.compareAndSet(false, true)) {
            EventQueue.invokeLater(() -> show(fault));
        }
    }

    private void show(Throwable fault) {
        try {
            String sentence = Lines.broken(Texts.text("uncaught.sentence", Reasons.of(fault)));
            JOptionPane.showMessageDialog(null, sentence, Texts.text("uncaught.title"), JOptionPane.ERROR_MESSAGE);
        } finally {
            showing.set(false);
        }
    }
}
