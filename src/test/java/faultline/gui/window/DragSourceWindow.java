package faultline.gui.window;

import faultline.gui.FileTransferable;
import java.awt.Dialog;
import java.awt.dnd.DnDConstants;
import java.awt.dnd.DragSource;
import java.awt.dnd.DragSourceAdapter;
import java.awt.dnd.DragSourceDropEvent;
import java.nio.file.Path;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.JLabel;

/** A window from which files can be dragged, as from a file manager. */
final class DragSourceWindow {

    private static final int WIDTH = 150;
    private static final int HEIGHT = 120;
    /** The distance from the edges of the screen, pixels. */
    private static final int MARGIN = 20;

    /** The property of the window with what was done with the files, an action of DnDConstants; null before a drop. */
    static final String DROP_ACTION = "dropAction";

    private DragSourceWindow() {}

    /**
     * Creates the window, not yet visible, whose files may be copied or moved, at the right of the screen: over the
     * window under test if that is wide. A modal dialog does not block it, as one does not block another program.
     */
    static JFrame create(Path... files) {
        JFrame frame = new JFrame("Files");
        frame.setModalExclusionType(Dialog.ModalExclusionType.APPLICATION_EXCLUDE);
        JLabel label = new JLabel(files[0].getFileName().toString());
        DragSource.getDefaultDragSource()
                .createDefaultDragGestureRecognizer(
                        label,
                        DnDConstants.ACTION_COPY_OR_MOVE,
                        gesture -> gesture.startDrag(
                                null,
                                new FileTransferable(
                                        Stream.of(files).map(Path::toFile).toList()),
                                new DragSourceAdapter() {
                                    @Override
                                    public void dragDropEnd(DragSourceDropEvent event) {
                                        frame.getRootPane().putClientProperty(DROP_ACTION, event.getDropAction());
                                    }
                                }));
        frame.add(label);
        int screen = frame.getToolkit().getScreenSize().width;
        frame.setBounds(screen - WIDTH - MARGIN, 3 * MARGIN, WIDTH, HEIGHT);
        return frame;
    }
}
