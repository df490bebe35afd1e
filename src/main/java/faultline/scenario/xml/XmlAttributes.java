package faultline.scenario.xml;

import java.util.AbstractMap;
import java.util.AbstractSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Set;

/** The attributes of one element in the order of the file. They are few: two lists are smaller than a hash table. */
final class XmlAttributes extends AbstractMap<String, String> {

    private final List<String> names;
    private final List<String> values;

    /** Creates a map of distinct names to the values with the same indices. */
    XmlAttributes(List<String> names, List<String> values) {
        this.names = names;
        this.values = values;
    }

    @Override
    public String get(Object name) {
        int index = names.indexOf(name);
        return index < 0 ? null : values.get(index);
    }

    @Override
    public boolean containsKey(Object name) {
        return names.contains(name);
    }

    @Override
    public Set<Map.Entry<String, String>> entrySet() {
        return new AbstractSet<>() {
            @Override
            public Iterator<Map.Entry<String, String>> iterator() {
                return new EntryIterator();
            }

            @Override
            public int size() {
                return names.size();
            }
        };
    }

    /** Much faster than a stream, which matters for files of many elements. */
    private final class EntryIterator implements Iterator<Map.Entry<String, String>> {

        private int next;

        @Override
        public boolean hasNext() {
            return next < names.size();
        }

        @Override
        public Map.Entry<String, String> next() {
            if (!hasNext()) {
                throw new NoSuchElementException();
            }
            return Map.entry(names.get(next), values.get(next++));
        }
    }
}
