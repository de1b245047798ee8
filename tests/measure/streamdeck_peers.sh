#!/bin/sh
# streamdeck_peers.sh [FOLDER] - our reports for Stream Decks beside two other programs'
#
# The npm package @elgato-stream-deck/core and Debian's python3-elgato-streamdeck draw the same
# pictures on devices that only listen. Every report must be the same; JPEG files are ours in all of
# them, and are read by djpeg and compared with the pixels that the others would have encoded.
# Needs node and npm, python3-elgato-streamdeck, libjpeg-turbo-progs; exit status 2 when one is not
# there. SPDX-License-Identifier: MIT
set -u
program=${PROGRAM:-build/host/tests/measure/test_hid_deck_reports}
folder=${1:-${BUILD:-build}/streamdeck}
package=@elgato-stream-deck/core@7.6.3
python=/usr/bin/python3 # Debian's, whatever else is first in the path

missing() {
    echo "streamdeck_peers.sh: there is no $1; install it (apt-get install $2)" >&2
    exit 2
}
command -v djpeg >/dev/null 2>&1 || missing djpeg libjpeg-turbo-progs
command -v npm >/dev/null 2>&1 || missing npm npm
"$python" -c 'import StreamDeck' 2>/dev/null ||
    missing "library for python3" python3-elgato-streamdeck
mkdir -p "$folder/sent" "$folder/npm"
"$program" "$folder/sent" || exit 1
if [ ! -d "$folder/npm/node_modules/@elgato-stream-deck" ]; then
    npm install --silent --no-audit --no-fund --prefix "$folder/npm" "$package" >&2 || {
        echo "streamdeck_peers.sh: npm cannot install $package; see its message above" >&2
        exit 2
    }
fi
status=0
"$python" tests/measure/streamdeck_peer.py "$folder/sent" || status=1
echo "$package:"
NODE_PATH=$folder/npm/node_modules node tests/measure/streamdeck_peer.js "$folder/sent" || status=1
exit $status
