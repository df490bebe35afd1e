package faultline.io;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * The default file system with an attacker who guesses names: where a file is about to be created, there is a symbolic
 * link to the victim at the last moment. After some links the attacker gives up.
 */
final class PlantedLinks extends ForwardingFileSystemProvider {

    private final Path victim;
    private final int maxLinks;
    private final List<Path> links = new ArrayList<>();

    PlantedLinks(Path victim, int maxLinks) {
        this.victim = victim;
        this.maxLinks = maxLinks;
    }

    /** Returns the links so far, as paths of the default file system. */
    List<Path> links() {
        return List.copyOf(links);
    }

    private void plant(Path path, Set<? extends OpenOption> options) throws IOException {
        boolean creates =
                options.contains(StandardOpenOption.CREATE) || options.contains(StandardOpenOption.CREATE_NEW);
        if (creates && links.size() < maxLinks) {
            links.add(Files.createSymbolicLink(unwrap(path), victim));
        }
    }

    @Override
    public SeekableByteChannel newByteChannel(
            Path path, Set<? extends OpenOption> options, FileAttribute<?>... attributes) throws IOException {
        plant(path, options);
        return super.newByteChannel(path, options, attributes);
    }

    @Override
    public FileChannel newFileChannel(Path path, Set<? extends OpenOption> options, FileAttribute<?>... attributes)
            throws IOException {
        plant(path, options);
        return super.newFileChannel(path, options, attributes);
    }

    @Override
    public DirectoryStream<Path> newDirectoryStream(Path folder, DirectoryStream.Filter<? super Path> filter)
            throws IOException {
        throw new IOException("the attacker lets no one list " + folder);
    }
}
