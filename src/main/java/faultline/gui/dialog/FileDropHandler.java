package faultline.gui.dialog;

import faultline.gui.text.Messages;
import java.awt.EventQueue;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.TransferHandler;

/**
 * Passes on the files that are dropped on the window. The drop has ended by then, so that the other program does not
 * wait for the answer to a question.
 */
final class FileDropHandler extends TransferHandler {

    private static final String FILES = "file:///";
    private static final String LOCAL_HOST = "file://localhost/";
    static final DataFlavor URI_LIST = new DataFlavor("text/uri-list;class=java.lang.String", null);

    private final transient Consumer<List<Path>> opener;
    private final transient Consumer<String> note;

    /** Creates a handler; {@code note} receives a sentence if something else than files of this computer is dropped. */
    FileDropHandler(Consumer<List<Path>> opener, Consumer<String> note) {
        this.opener = opener;
        this.note = note;
    }

    /** Accepts files that may be copied: a program deletes files that it moves, which are only read here. */
    @Override
    public boolean canImport(TransferSupport support) {
        if (!support.isDataFlavorSupported(DataFlavor.javaFileListFlavor)) {
            return false;
        }
        if (support.isDrop()) {
            if ((support.getSourceDropActions() & COPY) == 0) {
                return false;
            }
            support.setDropAction(COPY);
        }
        return true;
    }

    @Override
    public boolean importData(TransferSupport support) {
        if (!canImport(support)) {
            return false;
        }
        try {
            List<File> dropped = droppedFiles(support.getTransferable());
            dropped.stream()
                    .filter(file -> !FileDialogs.isPath(file))
                    .findFirst()
                    .ifPresent(file -> note.accept(Messages.get("files.badName", file.getName())));
            List<Path> files = dropped.isEmpty()
                    ? linkedFiles(support.getTransferable())
                    : dropped.stream()
                            .filter(FileDialogs::isPath)
                            .map(File::toPath)
                            .toList();
            if (files.isEmpty()) {
                if (dropped.isEmpty()) {
                    note.accept(Messages.get("note.noLocalFile"));
                }
                return false;
            }
            EventQueue.invokeLater(() -> opener.accept(files));
            return true;
        } catch (UnsupportedFlavorException | IOException lost) {
            return false;
        }
    }

    /** Returns the files of this computer that Java finds; it leaves out those with a host name, even of this one. */
    private static List<File> droppedFiles(Transferable dropped) throws UnsupportedFlavorException, IOException {
        Object data = dropped.getTransferData(DataFlavor.javaFileListFlavor);
        Stream<?> files = data instanceof List<?> list ? list.stream() : Stream.empty();
        return files.filter(File.class::isInstance).map(File.class::cast).toList();
    }

    private static List<Path> linkedFiles(Transferable dropped) throws UnsupportedFlavorException, IOException {
        return dropped.isDataFlavorSupported(URI_LIST)
                ? filesOf(dropped.getTransferData(URI_LIST).toString())
                : List.of();
    }

    private static List<Path> filesOf(String uris) {
        return uris.lines()
                .map(String::strip)
                .filter(uri -> uri.regionMatches(true, 0, LOCAL_HOST, 0, LOCAL_HOST.length()))
                .flatMap(uri -> fileOf(FILES + uri.substring(LOCAL_HOST.length())))
                .toList();
    }

    /** Returns the file of a URI, or nothing if it is invalid. */
    private static Stream<Path> fileOf(String uri) {
        try {
            return Stream.of(Path.of(URI.create(uri)));
        } catch (IllegalArgumentException invalid) {
            return Stream.empty();
        }
    }
}
