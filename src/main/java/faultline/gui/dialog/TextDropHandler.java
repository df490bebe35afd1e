package faultline.gui.dialog;

import java.awt.Component;
import java.awt.Container;
import java.awt.datatransfer.Clipboard;
import java.awt.event.ContainerAdapter;
import java.awt.event.ContainerEvent;
import java.awt.event.ContainerListener;
import java.awt.event.InputEvent;
import java.util.Arrays;
import javax.swing.CellRendererPane;
import javax.swing.JComponent;
import javax.swing.TransferHandler;
import javax.swing.text.JTextComponent;

/** Passes on the files that are dropped on a text component. All else is done by the component's own handler. */
public final class TextDropHandler extends TransferHandler {

    private final transient TransferHandler text;
    private final transient TransferHandler files;

    private TextDropHandler(TransferHandler text, TransferHandler files) {
        this.text = text;
        this.files = files;
    }

    /** Passes the files that are dropped on any text component in a container, also a later one, to a handler. */
    public static void install(Container root, TransferHandler files) {
        install(root, files, new ContainerAdapter() {
            @Override
            public void componentAdded(ContainerEvent event) {
                install(event.getChild(), files, this);
            }
        });
    }

    private static void install(Component component, TransferHandler files, ContainerListener onAdded) {
        if (component instanceof JTextComponent field && !(field.getTransferHandler() instanceof TextDropHandler)) {
            field.setTransferHandler(new TextDropHandler(field.getTransferHandler(), files));
        }
        // The renderers in such a pane take no drops, and lists of other windows may share them.
        if (component instanceof Container container
                && !(component instanceof CellRendererPane)
                && !Arrays.asList(container.getContainerListeners()).contains(onAdded)) {
            container.addContainerListener(onAdded);
            for (Component child : container.getComponents()) {
                install(child, files, onAdded);
            }
        }
    }

    /** Returns whether files are dropped; pasted ones are not opened. */
    private boolean takesFiles(TransferSupport support) {
        return support.isDrop() && files.canImport(support);
    }

    @Override
    public boolean canImport(TransferSupport support) {
        boolean forWindow = takesFiles(support);
        if (support.isDrop()) {
            // The caret does not show where text would be inserted.
            support.setShowDropLocation(!forWindow);
        }
        return forWindow || text.canImport(support);
    }

    @Override
    public boolean importData(TransferSupport support) {
        return (takesFiles(support) ? files : text).importData(support);
    }

    @Override
    public int getSourceActions(JComponent source) {
        return text.getSourceActions(source);
    }

    @Override
    public void exportAsDrag(JComponent source, InputEvent event, int action) {
        text.exportAsDrag(source, event, action);
    }

    @Override
    public void exportToClipboard(JComponent source, Clipboard clipboard, int action) {
        text.exportToClipboard(source, clipboard, action);
    }
}
