package faultline.gui.window;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.dnd.DnDConstants;
import java.awt.dnd.DragSource;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JFrame;
import javax.swing.JLabel;

/** A window from which files can be dragged, as from a file manager. */
final class DragSourceWindow {

    private static final int WIDTH = 150;
    private static final int HEIGHT = 120;
    /** The distance from the edges of the screen, pixels. */
    private static final int MARGIN = 20;

    private DragSourceWindow() {}

    /** Creates the window, not yet visible, at the right of the screen: over the window under test if that is wide. */
    static JFrame create(Path... files) {
        JFrame frame = new JFrame("Files");
        JLabel label = new JLabel(files[0].getFileName().toString());
        DragSource.getDefaultDragSource()
                .createDefaultDragGestureRecognizer(
                        label,
                        DnDConstants.ACTION_COPY,
                        gesture -> gesture.startDrag(DragSource.DefaultCopyDrop, new FileTransferable(List.of(files))));
        frame.add(label);
        int screen = frame.getToolkit().getScreenSize().width;
        frame.setBounds(screen - WIDTH - MARGIN, 3 * MARGIN, WIDTH, HEIGHT);
        return frame;
    }

    /** A list of files. */
    private record FileTransferable(List<Path> files) implements Transferable {
        @Override
        public DataFlavor[] getTransferDataFlavors() {
            return new DataFlavor[] {DataFlavor.javaFileListFlavor};
        }

        @Override
        public boolean isDataFlavorSupported(DataFlavor flavor) {
            return flavor.equals(DataFlavor.javaFileListFlavor);
        }

        @Override
        public Object getTransferData(DataFlavor flavor) {
            return files.stream().map(Path::toFile).toList();
        }
    }
}
