package faultline.floorplan;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import javax.imageio.stream.ImageInputStreamImpl;

/**
 * An image file that is read in large pieces. The stream of the JDK calls the operating system for each number of the
 * file, which takes seconds for an image with a million small parts.
 */
final class BufferedImageInput extends ImageInputStreamImpl {

    private static final int BUFFER_BYTES = 1 << 16;

    private final SeekableByteChannel file;
    /** The bytes of the file from an offset on, up to the limit of the buffer. */
    private final ByteBuffer buffer = ByteBuffer.allocate(BUFFER_BYTES).limit(0);

    private long offset;

    /** Creates a stream that reads a file from its beginning and closes it. */
    BufferedImageInput(SeekableByteChannel file) {
        this.file = file;
    }

    @Override
    public int read() throws IOException {
        byte[] one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
    }

    /** Reads fewer bytes only at the end of the file: the superclass reads each number by one call. */
    @Override
    public int read(byte[] bytes, int start, int length) throws IOException {
        checkClosed();
        bitOffset = 0;
        int total = 0;
        while (total < length && moveBuffer()) {
            int count = Math.min(length - total, buffer.remaining());
            buffer.get(bytes, start + total, count);
            streamPos += count;
            total += count;
        }
        return total == 0 && length > 0 ? -1 : total;
    }

    /** Moves the buffer to the position of the stream; returns false at the end of the file. */
    private boolean moveBuffer() throws IOException {
        long position = streamPos - offset;
        if (position < 0 || position >= buffer.limit()) {
            offset = streamPos;
            buffer.clear();
            int count = file.position(offset).read(buffer);
            buffer.limit(Math.max(0, count));
            position = 0;
        }
        buffer.position((int) position);
        return buffer.hasRemaining();
    }

    @Override
    public long length() {
        try {
            return file.size();
        } catch (IOException e) {
            return -1;
        }
    }

    @Override
    public void close() throws IOException {
        super.close();
        file.close();
    }
}
